"""Resistance of a copper wire over its temperature while it is cooled to 2 K, one and a half hours. Below 50 K it levels off."""

from formats.clock import since_first
from models.bends import bends
from readers.stoner import tagged_table

HAND_BUILT = "soft bend"


def rows(content):
    frame = tagged_table(content).dropna()
    return {"time_s": since_first(frame["Elapsed Time"]), "sample_k": frame["T (K)"], "resistance_ohm": frame.Resistance}


def models(c):
    return c["resistance_ohm"], bends(c["resistance_ohm"], c["sample_k"])
