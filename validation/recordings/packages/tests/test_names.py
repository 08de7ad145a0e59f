"""Names of answers against right names."""

import unittest

import names

ONE = [["nonlinearity", "saturation"]]
TWO = [["friction"], ["offset_drift", "late_driver"]]
NOTHING = [["agrees"]]
NEXT_TO_NOTHING = [["agrees", "time_offset"]]


def found(*effects, verdict="explained", ambiguity=()):
    return {"verdict": verdict, "findings": [{"effect": effect} for effect in effects], "ambiguity": list(ambiguity)}


class Judged(unittest.TestCase):
    def test_one_of_the_right_names_is_right(self):
        self.assertEqual(names.judged(found("saturation"), ONE), "right")
        self.assertEqual(names.judged(found("friction"), ONE), "wrong")

    def test_a_set_that_holds_the_cause_is_right(self):
        rivals = [["friction", "nonlinearity"]]
        self.assertEqual(names.judged(found("friction", ambiguity=rivals), ONE), "right")

    def test_a_name_that_came_later_counts_as_what_the_set_calls_it(self):
        loop = [["friction", "readout_lag"], ["nonlinearity", "saturation"]]
        self.assertEqual(names.judged(found("saturating_loop"), loop), "right")
        self.assertEqual(names.judged(found("saturating_loop"), [["friction"]]), "near")
        self.assertEqual(names.judged(found("saturating_loop"), NOTHING), "false")
        self.assertEqual(names.judged(found("slow_response", ambiguity=[["slow_response", "settling"]]), TWO), "near")

    def test_a_name_too_many_or_too_few_is_near(self):
        self.assertEqual(names.judged(found("saturation", "friction"), ONE), "near")
        self.assertEqual(names.judged(found("friction"), TWO), "near")
        self.assertEqual(names.judged(found("late_driver", "friction"), TWO), "right")

    def test_nothing_is_right_where_nothing_is_missing_and_the_answer_says_so(self):
        self.assertEqual(names.judged(found(verdict="agrees"), NOTHING), "right")
        self.assertEqual(names.judged(found(verdict="unexplained"), NOTHING), "missed")
        self.assertEqual(names.judged(found("friction"), NOTHING), "false")
        self.assertEqual(names.judged(found(verdict="agrees"), ONE), "missed")

    def test_where_next_to_nothing_is_missing_both_are_right(self):
        self.assertEqual(names.judged(found(verdict="agrees"), NEXT_TO_NOTHING), "right")
        self.assertEqual(names.judged(found("time_offset"), NEXT_TO_NOTHING), "right")
        self.assertEqual(names.judged(found("friction"), NEXT_TO_NOTHING), "wrong")
