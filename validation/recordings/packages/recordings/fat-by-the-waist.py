"""How much fat is in 252 men, by weighing them under water, over their waist. Of two with one waist the heavier has more of something else."""

from models.drivers import of_drivers
from models.fitting import line, scaled
from readers.faraway import book_table

HAND_BUILT = "slope by weight"


def rows(content):
    return book_table(content, waist_cm="abdom", weight_lb="weight", fat_percent="brozek")


def models(c):
    y, x, weight = c["fat_percent"], c["waist_cm"], c["weight_lb"]
    u, v = scaled(x), scaled(weight)
    return y, {
        **of_drivers(y, x, weight=weight),
        "slope by weight alone": line(y, x, u * v),
        "waist over weight": line(y, x, x / weight),
    }
