"""PNG, TIFF and JPEG files with what photographs say beside their pixels, written and read by nothing but Python's own
library. A picture is a list of rows, a row a list of pixels, a pixel a tuple of samples."""
import itertools
import struct
import zlib


def chunk(name, data):
    return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))


def png(rows, bits=8, before=(), after=()):
    """`before` and `after` the pixels: further chunks, as pairs of name and bytes."""
    channels = len(rows[0][0])
    kind = {1: 0, 2: 4, 3: 2, 4: 6}[channels]
    form = ">" + ("H" if bits == 16 else "B") * (channels * len(rows[0]))
    raw = b"".join(b"\0" + struct.pack(form, *(v for p in row for v in p)) for row in rows)
    head = struct.pack(">IIBBBBB", len(rows[0]), len(rows), bits, kind, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + b"".join(chunk(*c) for c in before) +
            chunk(b"IDAT", zlib.compress(raw)) + b"".join(chunk(*c) for c in after) + chunk(b"IEND", b""))


def chunks_of(data):
    at, out = 8, []
    while at < len(data):
        length, name = struct.unpack(">I4s", data[at:at + 8])
        out.append((name, data[at + 8:at + 8 + length]))
        at += 12 + length
    return out


def unfiltered(kind, line, above, step):
    """A row's bytes, from those of its filter and the row above; a pixel has `step` bytes."""
    if kind == 0:
        return line
    if kind == 1:
        out = bytearray(len(line))
        for first in range(step):
            out[first::step] = bytes(v & 255 for v in itertools.accumulate(line[first::step]))
        return bytes(out)
    if kind == 2:
        return bytes((v + b) & 255 for v, b in zip(line, above))
    # The pixel to the left and the one above it are 0 before the first.
    out, corners = bytearray(step) + line, bytes(step) + above
    if kind == 3:
        for i, b in enumerate(above, step):
            out[i] = (out[i] + (out[i - step] + b) // 2) & 255
    elif kind == 4:
        for i, b in enumerate(above, step):
            a, c = out[i - step], corners[i - step]
            to_a, to_b, to_c = abs(b - c), abs(a - c), abs(a + b - 2 * c)
            out[i] = (out[i] + (a if to_a <= to_b and to_a <= to_c else b if to_b <= to_c else c)) & 255
    else:
        raise ValueError(f"no filter of PNG: {kind}")
    return bytes(out[step:])


def read_png(data):
    """Rows and bits of a picture without palette and interlacing."""
    all_chunks = chunks_of(data)
    width, height, bits, kind, _, _, _ = struct.unpack(">IIBBBBB", all_chunks[0][1])
    channels = {0: 1, 2: 3, 4: 2, 6: 4}[kind]
    raw = zlib.decompress(b"".join(d for n, d in all_chunks if n == b"IDAT"))
    step = channels * bits // 8
    size, above, rows = width * step, bytes(width * step), []
    for y in range(height):
        above = unfiltered(raw[y * (size + 1)], raw[y * (size + 1) + 1:(y + 1) * (size + 1)], above, step)
        values = struct.unpack(">" + ("H" if bits == 16 else "B") * (width * channels), above)
        rows.append(list(zip(*[iter(values)] * channels)))
    return rows, bits


def profile_in_png(data):
    for name, text in chunks_of(data):
        if name == b"iCCP":
            return zlib.decompress(text[text.index(b"\0") + 2:])
    return None


def tiff_block(entries, order="<", at=0):
    """A directory of tags: (tag, type, values), type 2 and 7 of bytes, 3 and 4 of whole numbers."""
    head = (b"II*\0" if order == "<" else b"MM\0*") + struct.pack(order + "I", 8)
    body, extra = b"", b""
    place = 8 + 2 + 12 * len(entries) + 4 + at
    for tag, kind, values in sorted(entries):
        data = values if kind in (2, 7) else struct.pack(order + {3: "H", 4: "I"}[kind] * len(values), *values)
        count = len(data) if kind in (2, 7) else len(values)
        body += struct.pack(order + "HHI", tag, kind, count)
        if len(data) > 4:
            body += struct.pack(order + "I", place + len(extra))
            extra += data + b"\0" * (len(data) % 2)
        else:
            body += data.ljust(4, b"\0")
    return head + struct.pack(order + "H", len(entries)) + body + b"\0" * 4 + extra


def tiff(rows, more=(), order="<"):
    """8 bits a sample. `more`: further tags."""
    height, width, channels = len(rows), len(rows[0]), len(rows[0][0])
    pixels = bytes(v for row in rows for p in row for v in p)
    entries = [(256, 4, [width]), (257, 4, [height]), (258, 3, [8] * channels), (259, 3, [1]),
               (262, 3, [2 if channels == 3 else 1]), (277, 3, [channels]), (278, 4, [height]),
               (279, 4, [len(pixels)]), (273, 4, [0])] + list(more)
    start = len(tiff_block(entries, order))
    entries = [(273, 4, [start]) if e[0] == 273 else e for e in entries]
    return tiff_block(entries, order) + pixels


def more_pages(data, kinds, order="<"):
    """A TIFF file with a further directory of the same pixels for each kind (NewSubfileType; None: it says none)."""
    count = struct.unpack(order + "H", data[8:10])[0]
    entries, link = data[10:10 + 12 * count], 10 + 12 * count
    for kind in kinds:
        said = b"" if kind is None else struct.pack(order + "HHII", 254, 4, 1, kind)
        place = len(data)
        data = data[:link] + struct.pack(order + "I", place) + data[link + 4:]
        data += struct.pack(order + "H", count + (kind is not None)) + said + entries
        link = len(data)
        data += struct.pack(order + "I", 0)
    return data


def exif(orientation, order=">"):
    return tiff_block([(274, 3, [orientation])], order)


def segment(mark, data):
    return struct.pack(">BBH", 255, mark, len(data) + 2) + data


def profile_segments(profile, size):
    parts = [profile[i:i + size] for i in range(0, len(profile), size)]
    return [segment(0xE2, b"ICC_PROFILE\0" + bytes([i + 1, len(parts)]) + p) for i, p in enumerate(parts)]


def jpeg(blocks, segments=(), adobe=None):
    """Blocks of 8 x 8 pixels of one colour each, exact to half a level: a picture of what blocks mean alone. Samples are
    stored as they are: of three channels with Adobe's mark they are RGB, of four inks, which it has inverted."""
    channels, rows, columns = len(blocks[0][0]), len(blocks), len(blocks[0])
    out = b"\xff\xd8" + b"".join(segments)
    if adobe is None:
        adobe = channels > 1
    if adobe:
        out += segment(0xEE, b"Adobe\0\x64\0\0\0\0\0")
    out += segment(0xDB, b"\0" + b"\1" * 64)
    out += segment(0xC0, struct.pack(">BHHB", 8, 8 * rows, 8 * columns, channels) +
                   b"".join(bytes([i + 1, 0x11, 0]) for i in range(channels)))
    sizes = bytes(range(12))  # the number of bits of a difference; all codes have four bits
    out += segment(0xC4, b"\0" + bytes([0, 0, 0, 12] + [0] * 12) + sizes)
    out += segment(0xC4, b"\x10" + bytes([1] + [0] * 15) + b"\0")  # the end of a block
    out += segment(0xDA, bytes([channels]) + b"".join(bytes([i + 1, 0]) for i in range(channels)) + b"\0\x3f\0")
    bits, before = "", [0] * channels
    for row in blocks:
        for pixel in row:
            for c, value in enumerate(pixel):
                level = (value - 128) * 8
                step, before[c] = level - before[c], level
                size = abs(step).bit_length()
                bits += format(size, "04b")
                if size:
                    bits += format(step if step > 0 else step + (1 << size) - 1, "0%db" % size)
                bits += "0"
    bits += "1" * (-len(bits) % 8)
    scan = bytes(int(bits[i:i + 8], 2) for i in range(0, len(bits), 8))
    return out + scan.replace(b"\xff", b"\xff\0") + b"\xff\xd9"
