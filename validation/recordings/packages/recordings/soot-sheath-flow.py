"""Flow of clean air around the sample of a soot photometer on a ship in the ice, as a mass, over the same flow as a volume that its controller holds, a day in means of half a minute. The chamber cools and warms by 10 K, the pressure falls."""

from formats.soot_photometer import mean_rows, photometer
from models.fitting import line, through_zero
from models.lags import usual

HAND_BUILT = "gas law"


def rows(content):
    names = {"chamber_c": "Chamber Temp (C)", "chamber_hpa": "Chamber Pressure (mBar)", "volume_cm3_min": "Sheath Flow Read (vccm)", "mass_scm3_min": "Sheath Flow Read (sccm)"}
    return mean_rows(photometer(content, **names), 30)


def models(c):
    y, x, t, warm, pressure = c["mass_scm3_min"], c["volume_cm3_min"], c["time_s"], c["chamber_c"], c["chamber_hpa"]
    return y, {
        **usual(y, x, t),
        "temperature": line(y, x, warm),
        "pressure": line(y, x, pressure),
        "gain by temperature": line(y, x, x * warm),
        "temperature, and pressure": line(y, x, warm, pressure),
        "temperature, bent, and pressure": line(y, x, warm, warm**2, pressure),
        "temperature, bent, pressure, and their product": line(y, x, warm, warm**2, pressure, warm * pressure),
        HAND_BUILT: through_zero(y, x * pressure / (warm + 273.15)),
    }
