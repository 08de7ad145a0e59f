"""Formats that packages share, from bytes to columns; times and rows of any of them."""
