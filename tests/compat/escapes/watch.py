"""What is done to files and folders, as the kernel tells it (inotify): neither name nor link hides it."""
import ctypes
import os
import struct

IN_ACCESS, IN_MODIFY = 0x1, 0x2
IN_MOVED_FROM, IN_MOVED_TO, IN_CREATE, IN_DELETE = 0x40, 0x80, 0x100, 0x200
IN_ISDIR, IN_DONT_FOLLOW = 0x40000000, 0x02000000
CHANGES = IN_MODIFY | IN_MOVED_FROM | IN_MOVED_TO | IN_CREATE | IN_DELETE
NAMES = {IN_ACCESS: "read", IN_MODIFY: "written", IN_MOVED_FROM: "moved away", IN_MOVED_TO: "moved there",
         IN_CREATE: "made", IN_DELETE: "removed"}
LIBC = ctypes.CDLL(None, use_errno=True)


class Watch:
    """Of folders with all that is in them now. Reads count where `reads` says so; a folder's list of names does not."""

    def __init__(self):
        self.file = LIBC.inotify_init1(os.O_NONBLOCK | os.O_CLOEXEC)
        if self.file < 0:
            raise OSError(ctypes.get_errno(), "inotify_init1")
        self.places = {}

    def add(self, folder, reads):
        self._add_one(folder, reads)
        for where, folders, files in os.walk(os.fsencode(folder)):
            for name in folders + files:
                self._add_one(os.path.join(where, name), reads)

    def _add_one(self, place, reads):
        mask = CHANGES | (IN_ACCESS if reads else 0) | IN_DONT_FOLLOW
        number = LIBC.inotify_add_watch(self.file, os.fsencode(place), mask)
        if number < 0:
            raise OSError(ctypes.get_errno(), "inotify_add_watch")
        self.places[number] = os.fsdecode(place)

    def told(self):
        """What was done since the last call, in words."""
        out = []
        while True:
            try:
                events = os.read(self.file, 1 << 16)
            except BlockingIOError:
                return sorted(set(out))
            at = 0
            while at < len(events):
                number, mask, _, length = struct.unpack_from("iIII", events, at)
                name = events[at + 16:at + 16 + length].rstrip(b"\0")
                at += 16 + length
                if mask & IN_ISDIR and not mask & CHANGES:
                    continue
                what = [text for bit, text in NAMES.items() if mask & bit]
                if what:
                    out.append(f"{self.places.get(number, '?')}/{os.fsdecode(name)}: {', '.join(what)}".replace("/:", ":"))

    def close(self):
        os.close(self.file)
