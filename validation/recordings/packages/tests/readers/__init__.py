"""Tests of readers: a file a package."""
