"""Creeping flow past discs in a square box that is periodic both ways, by forces on their rims: another method than the program's, to digits that it does not reach.

On each rim lie point forces; what they do to the fluid is the periodic Stokeslet (Hasimoto, J. Fluid Mech. 5, 317 (1959)), summed in the manner of Ewald. Velocity is
zero on all rims, and then inside, so that the mean over the box is the superficial velocity. The logarithm on a disc's own rim is integrated by the rule of Martensen and
Kussmaul (Kress, Linear Integral Equations, section 12.3). Viscosity is 1.
"""

import numpy as np

EULER_GAMMA = 0.5772156649015329
MODES = 12         # of the smooth part, in each direction and sense
SPLIT = 8.0        # between near and smooth part, over the box: either is below 1e-7 where it is cut off


def exponential_integral(x):
    """E1 of positive numbers: Abramowitz and Stegun, eqs. 5.1.11 and 5.1.22."""
    small, large = np.minimum(x, 2.0), np.maximum(x, 2.0)
    term, series = np.ones_like(x), -EULER_GAMMA - np.log(small)
    for n in range(1, 30):
        term = term * -small / n
        series = series - term / n
    fraction = np.zeros_like(x)
    for n in range(40, 0, -1):
        fraction = n / (1.0 + n / (large + fraction))
    return np.where(x <= 2.0, series, np.exp(-large) / (large + fraction))


TABLE = np.linspace(1e-9, SPLIT**2, 200001)
SMOOTH = exponential_integral(TABLE) + np.log(TABLE)  # E1 without its logarithm: straight lines between these are exact to 1e-8


def near_part(dx, dy, xi):
    """(1 / 4 pi) ((E1 / 2 - e) 1 + e rr / r^2), e = exp(-xi^2 r^2), as xx, xy, yy."""
    squared = dx * dx + dy * dy
    t = np.maximum(xi * xi * squared, 1e-300)
    e, half = np.exp(-t), 0.5 * (np.interp(t, TABLE, SMOOTH) - np.log(t))
    over = 1.0 / np.maximum(squared, 1e-300)
    return [(half - e + e * dx * dx * over) / (4 * np.pi), e * dx * dy * over / (4 * np.pi), (half - e + e * dy * dy * over) / (4 * np.pi)]


def smooth_part(x, y, L, xi):
    """Sum over wave numbers of (1 - kk / k^2) (1 + k^2 / 4 xi^2) exp(-k^2 / 4 xi^2) / (k^2 L^2) cos(k (x - x')), as xx, xy, yy."""
    m = np.arange(-MODES, MODES + 1) * 2 * np.pi / L
    kx, ky = (k.ravel() for k in np.meshgrid(m, m))
    half = (ky > 0) | ((ky == 0) & (kx > 0))  # the others are the same again
    kx, ky = kx[half], ky[half]
    k2 = kx * kx + ky * ky
    weight = 2 * (1 + k2 / (4 * xi * xi)) * np.exp(-k2 / (4 * xi * xi)) / (k2 * L * L)
    phase = np.outer(x, kx) + np.outer(y, ky)
    c, s = np.cos(phase), np.sin(phase)
    return [(c * w) @ c.T + (s * w) @ s.T for w in (weight * (1 - kx * kx / k2), -weight * kx * ky / k2, weight * (1 - ky * ky / k2))]


def own_rim(n, R, xi):
    """What replaces the near part among the n points of one rim: the smooth remainder plus the rule's weights for the logarithm, in units of the plain rule's."""
    angle = 2 * np.pi * np.arange(n) / n
    x, y, m = R * np.cos(angle), R * np.sin(angle), n // 2
    dx, dy = x[:, None] - x, y[:, None] - y
    apart = angle[:, None] - angle
    off = ~np.eye(n, dtype=bool)
    logarithm = np.zeros((n, n))
    logarithm[off] = np.log(4 * np.sin(apart[off] / 2) ** 2)
    k = np.arange(1, m)
    rule = -(2 * np.pi / m) * (np.cos(apart[:, :, None] * k) / k).sum(axis=2) - np.pi / m**2 * np.cos(m * apart)
    xx, xy, yy = near_part(dx, dy, xi)
    tangent = -np.sin(angle), np.cos(angle)
    middle = -np.log(xi * R) - EULER_GAMMA / 2 - 1
    parts = []
    for near, here in ((xx, middle + tangent[0] ** 2), (xy, tangent[0] * tangent[1]), (yy, middle + tangent[1] ** 2)):
        with_logarithm = 0.0 if near is xy else 1.0
        smooth = near + with_logarithm * logarithm / (8 * np.pi)
        smooth[~off] = here / (4 * np.pi)
        parts.append(smooth - with_logarithm * rule / (8 * np.pi) / (2 * np.pi / n))
    return parts


def permeability(centres, R, L, n=48):
    """The permeability tensor, an area: superficial velocity = it times the fall of pressure per length, for viscosity 1."""
    xi, discs = SPLIT / L, len(centres)
    angle = 2 * np.pi * np.arange(n) / n
    x = (centres[:, :1] + R * np.cos(angle)).ravel()
    y = (centres[:, 1:] + R * np.sin(angle)).ravel()
    dx, dy = x[:, None] - x, y[:, None] - y
    dx, dy = dx - L * np.round(dx / L), dy - L * np.round(dy / L)
    parts = near_part(dx, dy, xi)
    for part, own in zip(parts, own_rim(n, R, xi)):
        for k in range(discs):
            part[k * n:(k + 1) * n, k * n:(k + 1) * n] = own
    xx, xy, yy = (near + smooth for near, smooth in zip(parts, smooth_part(x, y, L, xi)))
    ones, zeros = np.ones(len(x)), np.zeros(len(x))
    flow = np.column_stack([np.concatenate([ones, zeros]), np.concatenate([zeros, ones])])
    # A pressure on all of a rim moves nothing: that part of the forces is free, and is kept out.
    normal = np.zeros((2 * len(x), discs))
    for k in range(discs):
        normal[k * n:(k + 1) * n, k], normal[len(x) + k * n:len(x) + (k + 1) * n, k] = np.cos(angle), np.sin(angle)
    forces = np.linalg.solve(np.block([[xx, xy], [xy, yy]]) + normal @ normal.T / n, flow)
    drag = np.array([forces[:len(x)].sum(axis=0), forces[len(x):].sum(axis=0)])
    return np.linalg.inv(drag / L**2)
