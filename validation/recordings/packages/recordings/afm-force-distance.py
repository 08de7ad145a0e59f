"""Force on the tip of an atomic force microscope over height, in and out: a contact by a power law before a bent baseline. A cubic did best on rows left out."""

import io

import numpy as np
import pandas as pd
from models.fitting import line, terms

HAND_BUILT = "cubic"


def rows(content):
    lines = content.decode("latin1").splitlines()
    start = next(k for k, line in enumerate(lines) if line.startswith("Extend Z"))
    d = pd.read_csv(io.StringIO("\n".join(lines[start:])))
    d.columns = ["extend_z", "extend_f", "retract_z", "retract_f"]
    extend, retract = d[["extend_z", "extend_f"]].dropna(), d[["retract_z", "retract_f"]].dropna()
    height, force = np.r_[extend.extend_z, retract.retract_z], np.r_[extend.extend_f, retract.retract_f]
    return {"row_s": np.arange(len(height)) * 1.0, "z_nm": height, "force_read_nn": force}


def models(c):
    y, z = c["force_read_nn"], (c["z_nm"] - c["z_nm"].min()) / 1000
    contact = terms(y, lambda p: [np.maximum(z - p[0], 0) ** np.clip(p[1], 0.5, 4), z, z * z], [0.9, 1.5])
    return y, {"line": line(y, z), HAND_BUILT: line(y, z, z**2, z**3), "contact before a bent baseline": contact}
