"""Models built by hand that recordings of several packages share."""
