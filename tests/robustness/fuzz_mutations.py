"""How the fuzzer spoils scripts and files. Everything is drawn from the random numbers that it is given.

A script is a list of lines, a line a list of words; files are bytes. No mutation makes a name that leads out of the folder.
"""

import re
import shutil

OURS = re.compile(rb"create_objects|mass_spring|swell|nve/cds|rigid/cds|\bheld\b|prescribed|lubrication/cds|fluid/|output/|restart|^variable|^guard|^accuracy")
NUMBERS = ["0", "-0", "1", "-1", "2", "3", "0.5", "-0.5", "1e-3", "1e3", "1e-12", "1e12", "1e-300", "1e300", "-1e300", "1e-320", "1.7976931348623157e308", "1e309", "nan", "-nan", "inf", "-inf",
           "2147483647", "2147483648", "-2147483648", "4294967296", "9223372036854775807", "9223372036854775808", "1e18", "1000000", "1000000000", "0x10", "1e", "e5", "1,5", "1.5.2", "--1", "+1", "\u0661",
           "1" * 400, "0." + "0" * 400 + "1", '""', "''", "NULL", "*", "1*", "v_", "v_nowhere", "v_speed", "${nowhere}", "${", "$x", "f_water[1]", "f_nowhere", "c_nowhere", "&", "#"]
VARIABLES = ["v_nowhere", "${nowhere}", "$(1/0)", "v_v_speed", "f_water", "v_"]
UNITS = ["si", "cgs", "lj", "micro", "nano", "real", "metal", "electron", "none", ""]
LEADS_OUT = re.compile(rb"(?:^|[\s\"'=,])/|\.\.|~")
NUMBER = re.compile(rb"[-+]?\d[\d.]*(?:[eE][-+]?\d+)?\Z")


def is_number(word):
    return NUMBER.match(word) is not None


class Vocabulary:
    """Words and lines of the whole corpus, for what stands where it does not belong."""

    def __init__(self, scripts):
        self.lines = sorted({line for script in scripts for line in script.splitlines() if OURS.search(line)})
        self.words = sorted({word for line in self.lines for word in line.split()})


def extreme(rng, word):
    """Another number for this one: an extreme, or a multiple."""
    if rng.random() < 0.3:
        try:
            return b"%.17g" % (float(word) * rng.choice([-1, 0.1, 10, 0.5, 2, 1e3, 1e-3, 1e6]) + rng.choice([0, 0, 1, -1]))
        except ValueError:
            pass
    return rng.choice(NUMBERS).encode()


def misspelt(rng, word):
    at = rng.randrange(len(word) + 1)
    letter = bytes([rng.choice(b"abcdefghijklmnopqrstuvwxyz_0123456789")])
    return rng.choice([word[:at] + letter + word[at:], word[:at] + word[at + 1:], word[:at] + letter + word[at + 1:], word.upper(), word[::-1]])


def number_changed(rng, words, vocabulary):
    places = [i for i, word in enumerate(words) if is_number(word)]
    if places:
        at = rng.choice(places)
        words[at] = extreme(rng, words[at])


def word_dropped(rng, words, vocabulary):
    words.pop(rng.randrange(len(words)))


def word_doubled(rng, words, vocabulary):
    at = rng.randrange(len(words))
    words.insert(at, words[at])


def words_swapped(rng, words, vocabulary):
    a, b = rng.randrange(len(words)), rng.randrange(len(words))
    words[a], words[b] = words[b], words[a]


def words_joined(rng, words, vocabulary):
    if len(words) > 1:
        at = rng.randrange(len(words) - 1)
        words[at:at + 2] = [words[at] + words[at + 1]]


def word_misspelt(rng, words, vocabulary):
    at = rng.randrange(len(words))
    words[at] = misspelt(rng, words[at])


def word_of_elsewhere(rng, words, vocabulary):
    words[rng.randrange(len(words))] = rng.choice(vocabulary.words)


def word_added(rng, words, vocabulary):
    words.insert(rng.randrange(len(words) + 1), rng.choice(vocabulary.words))


def word_long(rng, words, vocabulary):
    words[rng.randrange(len(words))] *= rng.choice([50, 1000, 20000])


def words_many(rng, words, vocabulary):
    words.extend(words[-rng.randrange(1, min(4, len(words)) + 1):] * rng.choice([10, 200, 3000]))


def cut_off(rng, words, vocabulary):
    del words[rng.randrange(len(words)):]


def variable_undefined(rng, words, vocabulary):
    words[rng.randrange(len(words))] = rng.choice(VARIABLES).encode()


def group_of_nobody(rng, words, vocabulary):
    if words[0] == b"fix" and len(words) > 2:
        words[2] = rng.choice([b"nobody", b"empty", b"all", b"one", b"still"])


IN_A_LINE = [number_changed] * 10 + [word_dropped, word_doubled, words_swapped, words_joined, word_misspelt, word_of_elsewhere, word_added] * 2 + [
    word_long, words_many, cut_off, variable_undefined, group_of_nobody]


def line_dropped(rng, lines, vocabulary):
    lines.pop(rng.randrange(len(lines)))


def line_doubled(rng, lines, vocabulary):
    lines.insert(rng.randrange(len(lines) + 1), rng.choice(lines))


def line_moved(rng, lines, vocabulary):
    line = lines.pop(rng.randrange(len(lines)))
    lines.insert(rng.randrange(len(lines) + 1), line)


def line_of_elsewhere(rng, lines, vocabulary):
    lines.insert(rng.randrange(len(lines) + 1), rng.choice(vocabulary.lines))


def units_changed(rng, lines, vocabulary):
    lines[0] = b"units " + rng.choice(UNITS).encode()


def lines_joined(rng, lines, vocabulary):
    at = rng.randrange(len(lines))
    lines[at] += rng.choice([b" &", b" ", b"\r", b"\0", b"\t#"])


AMONG_LINES = [line_dropped, line_doubled, line_moved, line_of_elsewhere, line_of_elsewhere, units_changed, lines_joined]


def bytes_changed(rng, data):
    """Bytes flipped, cut out, put in, or the end cut off."""
    if not data:
        return b"\0"
    at = rng.randrange(len(data))
    some = bytes(rng.randrange(256) for _ in range(rng.choice([1, 1, 2, 8, 64])))
    return rng.choice([
        data[:at] + bytes([data[at] ^ (1 << rng.randrange(8))]) + data[at + 1:], data[:at] + some + data[at:], data[:at] + data[at + len(some):], data[:at],
        data[:at] + some + data[at + len(some):], data[:at] + b"\xff\xfe\xc3\x28" + data[at:], data + some, data + data, data[:at] + bytes(rng.choice([8, 4096])) + data[at:]])


def chosen_line(rng, lines):
    ours = [i for i, line in enumerate(lines) if OURS.search(line)]
    return rng.choice(ours) if ours and rng.random() < 0.75 else rng.randrange(len(lines))


def script_changed(rng, data, vocabulary):
    lines = data.split(b"\n")[:-1] or [b""]
    kind = rng.random()
    if kind < 0.75:
        at = chosen_line(rng, lines)
        words = lines[at].split()
        if words:
            rng.choice(IN_A_LINE)(rng, words, vocabulary)
        lines[at] = b" ".join(words)
    elif kind < 0.93:
        rng.choice(AMONG_LINES)(rng, lines, vocabulary)
    else:
        return bytes_changed(rng, data)
    return b"\n".join(lines) + b"\n"


def cell_changed(rng, cells):
    at = rng.randrange(len(cells))
    cells[at] = rng.choice([extreme(rng, cells[at].strip()), b"", misspelt(rng, cells[at]), cells[at] * 5000, b" ", b'"' + cells[at] + b'"'])


def cell_dropped(rng, cells):
    cells.pop(rng.randrange(len(cells)))


def cell_doubled(rng, cells):
    cells.insert(rng.randrange(len(cells)), rng.choice(cells))


def cells_swapped(rng, cells):
    a, b = rng.randrange(len(cells)), rng.randrange(len(cells))
    cells[a], cells[b] = cells[b], cells[a]


def table_changed(rng, data):
    """A file of comma-separated values."""
    kind = rng.random()
    lines = data.split(b"\n")[:-1]
    if kind < 0.2 or not lines:
        return bytes_changed(rng, data)
    if kind < 0.7:
        at = rng.randrange(len(lines))
        cells = lines[at].split(b",")
        rng.choice([cell_changed, cell_changed, cell_changed, cell_dropped, cell_doubled, cells_swapped])(rng, cells)
        lines[at] = b",".join(cells)
    elif kind < 0.9:
        rng.choice([line_dropped, line_doubled, line_moved])(rng, lines, None)
    else:
        return rng.choice([b"", b"\n", b"#\n", b"\xef\xbb\xbf" + data, data.replace(b"\n", b"\r\n"), data.replace(b",", b";"), data[:-1], data.replace(b"\n", b"\r"), lines[0] + b"\n", data * 300])
    return b"\n".join(lines) + b"\n"


def file_replaced(rng, path):
    """The file is missing, or a folder stands in its place."""
    path.unlink()
    if rng.random() < 0.5:
        path.mkdir()


def mutate(rng, folder, vocabulary):
    """Spoils what is in the folder of a scene: its script, and the files that it reads."""
    script = folder / "in.script"
    for _ in range(rng.choice([1, 1, 1, 1, 2, 2, 3])):
        files = sorted(path for path in folder.iterdir() if path != script and path.is_file())
        if not files or rng.random() < 0.6:
            changed = script_changed(rng, script.read_bytes(), vocabulary)
            if not LEADS_OUT.search(changed):
                script.write_bytes(changed)
            continue
        file = rng.choice(files)
        if rng.random() < 0.06:
            file_replaced(rng, file)
        elif file.suffix == ".csv":
            file.write_bytes(table_changed(rng, file.read_bytes()))
        else:
            file.write_bytes(bytes_changed(rng, file.read_bytes()))


def prepare(rng, scenes, folder, vocabulary):
    """A scene of the corpus, spoilt, in `folder`; its name."""
    scene = rng.choice(scenes)
    shutil.copytree(scene, folder)
    before = {path: path.read_bytes() for path in folder.iterdir()}
    while all(path.is_file() and path.read_bytes() == content for path, content in before.items()):
        mutate(rng, folder, vocabulary)
    return scene.name
