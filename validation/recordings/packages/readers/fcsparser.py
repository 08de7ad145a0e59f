"""Reads files of the package fcsparser."""

import numpy as np
import pandas as pd


def cytometer(content):
    """Events of a flow cytometer file of floating numbers (FCS), by the names of its channels."""
    first, last, data = int(content[10:18]), int(content[18:26]), int(content[26:34])
    text = content[first : last + 1].decode("latin1")
    words = text[1:].split(text[0])
    told = dict(zip(words[::2], words[1::2]))
    channels, events = int(told["$PAR"]), int(told["$TOT"])
    values = np.frombuffer(content, ("<" if told["$BYTEORD"][0] == "1" else ">") + {"F": "f4", "D": "f8"}[told["$DATATYPE"]], channels * events, data)
    return pd.DataFrame(values.reshape(events, channels).astype(float), columns=[told[f"$P{k}N"] for k in range(1, channels + 1)])
