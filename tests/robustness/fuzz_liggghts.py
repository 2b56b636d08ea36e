"""Faults of LIGGGHTS 3.8.0 itself, in its own commands: each known by the command it came from and what was seen of it, and by nothing broader.

Stock liggghts does the same with that line, which is how a row is tried before it is written down.
"""

import re

# the last command that was read, what the program said (with sanitizers, or by Open MPI when it catches the signal), and why it is none of ours
FAULTS = [
    (r"^pair_coeff( +\S+)? *$", r"Force(::|6)bounds", "PairGran::coeff reads two words without looking whether there are two"),
    (r"^run\b", r"neighbor +(2147483647|\d{10,}|\d+e\+?\d\d+)\b[\s\S]*MPI_ERR_RANK", "Comm::setup counts in int how many boxes ghosts come from, and sends to ranks that do not exist"),
]


def last_command(screen):
    """The command during which the program ended: LIGGGHTS echoes each before it does it."""
    commands = [line for line in screen.splitlines() if re.match(r"[a-z_]+\s", line) and not line.startswith(("ERROR", "WARNING"))]
    return commands[-1] if commands else ""


def reason(screen):
    command = last_command(screen)
    return next((why for its_command, sign, why in FAULTS if re.search(its_command, command) and re.search(sign, screen)), None)
