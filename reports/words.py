"""Numbers and settings in words for people, the same in figures, tables and sentences."""
import math

_SUPERSCRIPT = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")


def power_of_ten(exponent):
    return "10" + str(exponent).translate(_SUPERSCRIPT)


def number(value, digits=3):
    """A number to so many significant digits: 0.0123, 12.3, 1.2·10⁻⁷, 25·10⁹."""
    if value is None or math.isnan(value):
        return "not a number"
    if math.isinf(value):
        return "−∞" if value < 0 else "∞"
    if value == 0:
        return "0"
    sign = "−" if value < 0 else ""
    mantissa, exponent = f"{abs(value):.{digits - 1}e}".split("e")
    exponent = int(exponent)
    if -4 < exponent < max(digits, 5):
        text = f"{abs(value):.{max(0, digits - 1 - exponent)}f}"
        return sign + (text.rstrip("0").rstrip(".") if "." in text else text)
    mantissa = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
    return sign + (power_of_ten(exponent) if mantissa == "1" else f"{mantissa}·{power_of_ten(exponent)}")


def error(value):
    """An error or a tolerance: two digits."""
    return number(value, 2)


def seconds(value, digits=2):
    """A duration with its unit: 12 µs, 1.2 ms, 3.4 s."""
    if value is None or math.isnan(value):
        return "–"
    for limit, scale, unit in ((1e-6, 1e9, "ns"), (1e-3, 1e6, "µs"), (1.0, 1e3, "ms"), (math.inf, 1.0, "s")):
        if value < limit * 0.9995:
            return f"{number(value * scale, digits)} {unit}"


def factor(value):
    return f"{number(value, 2)} ×"


def count(value, singular, plural=None):
    return f"{value} {singular if value == 1 else plural or singular + 's'}"


def size(value):
    """Bytes: 12 MB."""
    for scale, unit in ((1e9, "GB"), (1e6, "MB"), (1e3, "kB")):
        if value >= scale:
            return f"{number(value / scale, 2)} {unit}"
    return f"{value} B"


def setting(keys, without=()):
    """The keys of a setting by their last word: `order = 4, size = 0.125`."""
    shown = [f"{key.rsplit('.', 1)[-1].replace('_', ' ')} {value.strip(chr(34))}" for key, value in keys if key not in without]
    return ", ".join(shown)
