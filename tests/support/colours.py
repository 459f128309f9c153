"""Colours by matrix arithmetic, and ICC profiles written byte by byte, with Python's own library alone."""
import struct


def product(a, b):
    return [[sum(a[i][k] * b[k][j] for k in range(3)) for j in range(len(b[0]))] for i in range(3)]


def inverse(m):
    (a, b, c), (d, e, f), (g, h, i) = m
    det = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    return [[v / det for v in row] for row in ((e * i - f * h, c * h - b * i, b * f - c * e),
                                               (f * g - d * i, a * i - c * g, c * d - a * f),
                                               (d * h - e * g, b * g - a * h, a * e - b * d))]


D65, D50 = (0.3127, 0.3290), (0.96420, 1.0, 0.82491)
SRGB = ((0.64, 0.33), (0.30, 0.60), (0.15, 0.06))
DISPLAY_P3 = ((0.680, 0.320), (0.265, 0.690), (0.150, 0.060))
ADOBE = ((0.64, 0.33), (0.21, 0.71), (0.15, 0.06))
BRADFORD = [[0.8951, 0.2664, -0.1614], [-0.7502, 1.7135, 0.0367], [0.0389, -0.0685, 1.0296]]


def xyz_of(x, y):
    return [x / y, 1.0, (1 - x - y) / y]


def primaries_matrix(primaries, white=D65):
    """Linear RGB to XYZ."""
    columns = [list(c) for c in zip(*(xyz_of(*p) for p in primaries))]
    scale = product(inverse(columns), [[v] for v in xyz_of(*white)])
    return [[columns[i][j] * scale[j][0] for j in range(3)] for i in range(3)]


def to_d50(white=D65):
    cone = product(BRADFORD, [[a, b] for a, b in zip(xyz_of(*white), D50)])
    scale = [[cone[i][1] / cone[i][0] if i == j else 0.0 for j in range(3)] for i in range(3)]
    return product(inverse(BRADFORD), product(scale, BRADFORD))


def encoded(v):
    v = min(max(v, 0.0), 1.0)
    return 12.92 * v if v <= 0.0031308 else 1.055 * v ** (1 / 2.4) - 0.055


def decoded(v):
    return v / 12.92 if v <= 0.04045 else ((v + 0.055) / 1.055) ** 2.4


def srgb_of(values, primaries, decode, white=D65):
    """What colours of those primaries are in sRGB, each from 0 to 1."""
    light = [[decode(v)] for v in values]
    pcs = product(to_d50(white), product(primaries_matrix(primaries, white), light))
    return [encoded(v[0]) for v in product(inverse(product(to_d50(), primaries_matrix(SRGB))), pcs)]


def srgb_of_xyz(xyz):
    """Relative to D50."""
    light = product(inverse(product(to_d50(), primaries_matrix(SRGB))), [[v] for v in xyz])
    return [encoded(v[0]) for v in light]


def s15(v):
    return struct.pack(">i", round(v * 65536))


def profile(kind, space, pcs, tags, version):
    text = (b"desc\0\0\0\0" + struct.pack(">I", 5) + b"test\0" + bytes(78) if version < 4 else
            b"mluc\0\0\0\0" + struct.pack(">II2s2sII", 1, 12, b"en", b"US", 8, 28) + "test".encode("utf-16-be"))
    note = b"text\0\0\0\0free\0" if version < 4 else text
    tags = {b"desc": text, b"cprt": note, b"wtpt": b"XYZ \0\0\0\0" + b"".join(map(s15, D50)), **tags}
    table, data, start = struct.pack(">I", len(tags)), b"", 132 + 12 * len(tags)
    for name, value in tags.items():
        table += name + struct.pack(">II", start + len(data), len(value))
        data += value + bytes(-len(value) % 4)
    head = bytearray(128)
    head[0:4] = struct.pack(">I", start + len(data))
    head[8:12] = struct.pack(">I", version << 24)
    head[12:24] = kind + space + pcs
    head[36:40] = b"acsp"
    head[68:80] = b"".join(map(s15, D50))
    return bytes(head) + table + data


def curve(gamma):
    """0: sRGB's, as profiles of version 4 have it."""
    if gamma:
        return b"curv\0\0\0\0" + struct.pack(">IH", 1, round(gamma * 256)) + b"\0\0"
    return b"para\0\0\0\0\0\3\0\0" + b"".join(map(s15, (2.4, 1 / 1.055, 0.055 / 1.055, 1 / 12.92, 0.04045)))


def rgb_profile(primaries, gamma, version=2, white=D65):
    matrix = product(to_d50(white), primaries_matrix(primaries, white))
    tags = {}
    for i, name in enumerate((b"r", b"g", b"b")):
        tags[name + b"XYZ"] = b"XYZ \0\0\0\0" + b"".join(s15(matrix[j][i]) for j in range(3))
        tags[name + b"TRC"] = curve(gamma)
    return profile(b"mntr", b"RGB ", b"XYZ ", tags, version)


def grey_profile(gamma, version=2):
    return profile(b"mntr", b"GRAY", b"XYZ ", {b"kTRC": curve(gamma)}, version)


def inks_xyz(inks):
    """A press of its own: each ink takes a part of the light."""
    c, m, y, k = inks
    x, g, z = 1 - 0.7 * c, 1 - 0.6 * c - 0.3 * m, 1 - 0.8 * y
    return [D50[0] * max(0, x * (1 - 0.4 * m)) * (1 - k), max(0, g) * (1 - k), D50[2] * z * (1 - 0.2 * m) * (1 - k)]


def inks_profile():
    """Of four inks, with the corners of their cube alone."""
    corners = [[(i >> (3 - n)) & 1 for n in range(4)] for i in range(16)]
    nodes = b"".join(struct.pack(">3H", *(round(v * 32768) for v in inks_xyz(c))) for c in corners)
    line = struct.pack(">HH", 0, 65535)
    lut = (b"mft2\0\0\0\0" + bytes([4, 3, 2, 0]) + b"".join(s15(v) for v in (1, 0, 0, 0, 1, 0, 0, 0, 1)) +
           struct.pack(">HH", 2, 2) + line * 4 + nodes + line * 3)
    return profile(b"scnr", b"CMYK", b"XYZ ", {b"A2B0": lut}, 2)
