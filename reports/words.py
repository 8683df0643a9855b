"""Numbers and settings in words for people, the same in figures, tables and sentences."""
import math
import re

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


def written(value):
    """A value as it stands in a case, in the fewest digits that are still the same number: 0.4999, 10⁻⁸, squares."""
    try:
        number_ = float(value)
    except ValueError:
        if not value.startswith("["):
            return value.strip('"')
        inner = re.sub(r"[^\s,\[\]]+", lambda m: written(m.group()), value)
        return re.sub(r"\[\s+|\s+\]", lambda m: m.group().strip(), inner)
    text = repr(number_)
    if len(re.sub(r"e.*|\D", "", text).strip("0")) > 12:  # a quotient: its last digits say nothing
        text = f"{number_:.6g}"
    mantissa, _, exponent = text.partition("e")
    if not exponent and abs(number_) >= 1e5 and re.fullmatch(r"-?\d0+\.0", mantissa):
        mantissa, exponent = mantissa.rstrip("0.") or "0", len(mantissa.lstrip("-")) - 3
    if not exponent:
        return mantissa.removesuffix(".0").replace("-", "−")
    mantissa = mantissa.removesuffix(".0").replace("-", "−")
    power = power_of_ten(int(exponent))
    return power if mantissa == "1" else f"{mantissa}·{power}"


def key(dotted):
    """The last word of a scene key: `order` of mesh.order."""
    return dotted.rsplit(".", 1)[-1].replace("_", " ")


def setting(keys):
    """A setting in words: `order 4, size 0.125`."""
    return ", ".join(f"{key(name)} {written(value)}" for name, value in keys)
