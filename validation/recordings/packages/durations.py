"""Lengths of an hour, a day and a year in s."""

HOUR = 3600
DAY = 86400
YEAR = 365.25 * DAY
GREGORIAN_YEAR = 365.2425 * DAY
