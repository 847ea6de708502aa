"""A bent muscle by plane finite elements that share nothing with the program.

A muscle that is bent at constant curvature is the same at every section, and its two families of strands make each section a plane of symmetry: sections stay plane,
and a point at the height y of the present section is stretched along the muscle by l = λ (1 + κ y). The section in its own plane is free: it may become
oval, and the wall may thicken and thin as it likes. Quadrilaterals of four nodes with one mean dilatation each, neo-Hookean rubber; strands on the outer edge,
fixed to it, or of one stretch around the circumference ("sliding", as the program takes it). Newton's method with a Hessian of differences.

  python3 studies/bent_section.py          the tables of docs/models.md, "Bent muscles"; needs NumPy; about ten minutes (16 elements over half of the circumference)

hold: the centre of the outer area is held at y = 0 (the axis), for given λ and κ.   F = ∂Π/∂λ, M = ∂Π/∂κ per length at rest.
press: the section lies on a flat of the radius R about the centre of the bend, turning by ω per length at rest: l = ω (R + η), η the height above the
flat. T = ∂Π/∂ω, and the place of the centre of the outer area.
"""

import numpy as np

BULK = 500.0  # of the shear modulus
SCALE = 10.0  # mm per rad in Newton's steps


class Section:
    def __init__(self, outer, wall, angle_deg, k, mu, pressure, fixed, around=48, through=2):
        self.k, self.mu, self.p, self.fixed = k, mu, pressure, fixed
        self.c2, self.s2 = np.cos(np.radians(angle_deg)) ** 2, np.sin(np.radians(angle_deg)) ** 2
        phi = np.pi * np.arange(around + 1) / around  # 0: outside of the bend
        r = np.linspace(outer - wall, outer, through + 1)
        # The area of the polygon is that of the circle.
        r = r * np.sqrt((np.pi / around) / np.sin(np.pi / around))
        self.shape = (around + 1, through + 1)
        self.X = np.stack([r[None] * np.sin(phi)[:, None], r[None] * np.cos(phi)[:, None]], -1)
        n = np.arange(self.shape[0] * self.shape[1]).reshape(self.shape)
        self.el = np.stack([n[:-1, :-1], n[:-1, 1:], n[1:, 1:], n[1:, :-1]], -1).reshape(-1, 4)
        self.outer, self.bore = n[:, -1], n[:, 0]
        g = 1 / np.sqrt(3)
        self.gauss = []
        Xe = self.X.reshape(-1, 2)[self.el]
        for a in (-g, g):
            for b in (-g, g):
                N = 0.25 * np.array([(1 - a) * (1 - b), (1 + a) * (1 - b), (1 + a) * (1 + b), (1 - a) * (1 + b)])
                d = 0.25 * np.array([[-(1 - b), -(1 - a)], [1 - b, -(1 + a)], [1 + b, 1 + a], [-(1 + b), 1 - a]])
                J = np.einsum("eni,nj->eij", Xe, d)
                det = np.linalg.det(J)
                B = np.einsum("nj,eji->eni", d, np.linalg.inv(J))
                self.gauss.append((N, B, np.abs(det)))
        self.area = sum(w for _, _, w in self.gauss)
        edge = self.X[1:, -1] - self.X[:-1, -1]
        self.edge0 = np.hypot(*edge.T)
        # Free: all but x on the axis of symmetry.
        free = np.ones((*self.shape, 2), bool)
        free[0, :, 0] = free[-1, :, 0] = False
        self.free = free.ravel()

    def energy(self, x, stretch, sliding_stretch):
        """Π of half of the section without pressure, with its gradient; `stretch`: (value, slope) at heights y."""
        xy = x.reshape(-1, 2)
        xe, grad = xy[self.el], np.zeros_like(xy)
        total, dil, parts = 0.0, np.zeros(len(self.el)), []
        for N, B, w in self.gauss:
            F = np.einsum("eni,enj->eij", xe, B)
            l, l_y = stretch(np.einsum("n,en->e", N, xe[..., 1]))
            J2 = F[:, 0, 0] * F[:, 1, 1] - F[:, 0, 1] * F[:, 1, 0]
            co = np.stack([np.stack([F[:, 1, 1], -F[:, 1, 0]], -1), np.stack([-F[:, 0, 1], F[:, 0, 0]], -1)], -2)
            J = J2 * l
            I1 = (F**2).sum((1, 2)) + l**2
            iso = J ** (-2 / 3)
            total += (w * 0.5 * self.mu * (iso * I1 - 3)).sum()
            dJ = self.mu * 0.5 * iso * I1 * (-2 / 3) / J
            dF = self.mu * (iso[:, None, None] * F) + (dJ * l)[:, None, None] * co
            dl = self.mu * iso * l + dJ * J2
            dil += w * J
            parts.append((N, B, w, dF, dl, co, J2, l, l_y))
        mean = dil / self.area
        total += (self.area * 0.5 * BULK * self.mu * (mean - 1) ** 2).sum()
        pr = BULK * self.mu * (mean - 1)
        for N, B, w, dF, dl, co, J2, l, l_y in parts:
            dF = dF + (pr * l)[:, None, None] * co
            dl = dl + pr * J2
            ge = np.einsum("e,eij,enj->eni", w, dF, B)
            ge[..., 1] += (w * dl * l_y)[:, None] * N[None]
            np.add.at(grad, self.el, ge)
        # Strands: k (λf − 1)² per length of the outer edge, both families.
        o = self.outer
        d = xy[o[1:]] - xy[o[:-1]]
        length = np.hypot(*d.T)
        if self.fixed:
            h = length / self.edge0
            for t in (0.5 - 0.5 / np.sqrt(3), 0.5 + 0.5 / np.sqrt(3)):
                l, l_y = stretch((1 - t) * xy[o[:-1], 1] + t * xy[o[1:], 1])
                f = np.sqrt(self.c2 * l**2 + self.s2 * h**2)
                e = np.maximum(f - 1, 0)
                w = 0.5 * self.edge0
                total += (w * self.k * e**2).sum()
                by = w * 2 * self.k * e / f
                ge = (by * self.s2 * h / self.edge0 / length)[:, None] * d
                np.add.at(grad, o[1:], ge)
                np.add.at(grad, o[:-1], -ge)
                np.add.at(grad[:, 1], o[:-1], (1 - t) * by * self.c2 * l * l_y)
                np.add.at(grad[:, 1], o[1:], t * by * self.c2 * l * l_y)
        else:
            whole = self.edge0.sum()
            h = length.sum() / whole
            l = sliding_stretch(x)
            f = np.sqrt(self.c2 * l[0] ** 2 + self.s2 * h**2)
            e = max(f - 1, 0)
            total += whole * self.k * e**2
            by = whole * 2 * self.k * e / f
            ge = (by * self.s2 * h / whole / length)[:, None] * d
            np.add.at(grad, o[1:], ge)
            np.add.at(grad, o[:-1], -ge)
            grad += (by * self.c2 * l[0] * l[1]).reshape(-1, 2)
        return total, grad.ravel()

    def moment(self, x, which):
        """Area and first moment ∫ y dA of half of what a line of nodes encloses, with gradients."""
        a, b = x.reshape(-1, 2)[which[:-1]], x.reshape(-1, 2)[which[1:]]
        cross = b[:, 0] * a[:, 1] - a[:, 0] * b[:, 1]
        ga, gm = np.zeros((x.size // 2, 2)), np.zeros((x.size // 2, 2))
        s = a[:, 1] + b[:, 1]
        for nodes, dx, dy, own in ((which[:-1], -b[:, 1], b[:, 0], 1), (which[1:], a[:, 1], -a[:, 0], 1)):
            np.add.at(ga[:, 0], nodes, 0.5 * dx)
            np.add.at(ga[:, 1], nodes, 0.5 * dy)
            np.add.at(gm[:, 0], nodes, s * dx / 6)
            np.add.at(gm[:, 1], nodes, s * dy / 6 + cross / 6)
        return 0.5 * cross.sum(), (cross * s).sum() / 6, ga.ravel(), gm.ravel()

    def solve(self, potential, x, extra=0, origin=0.0):
        """Stationary point of `potential`(x with `extra` multipliers) → gradient, in polar coordinates: rubber moves around the circumference."""
        n = x.size
        xy = x.reshape(-1, 2) - [0, origin]
        z = np.concatenate([np.stack([SCALE * np.arctan2(xy[:, 0], xy[:, 1]), np.hypot(*xy.T)], -1).ravel(), np.zeros(extra)])
        free = np.concatenate([self.free, np.ones(extra, bool)])
        index = np.flatnonzero(free)

        def cartesian(z):
            psi, r = z[:n:2] / SCALE, z[1:n:2]
            return np.concatenate([np.stack([r * np.sin(psi), origin + r * np.cos(psi)], -1).ravel(), z[n:]])

        def gradient(z):
            psi, r = z[:n:2] / SCALE, z[1:n:2]
            g = potential(cartesian(z))[1]
            gx, gy = g[:n:2], g[1:n:2]
            polar = np.stack([r * (gx * np.cos(psi) - gy * np.sin(psi)) / SCALE, gx * np.sin(psi) + gy * np.cos(psi)], -1)
            return np.concatenate([polar.ravel(), g[n:]])[free]

        for _ in range(40):
            H, h = np.empty((len(index), len(index))), 1e-6
            for j, i in enumerate(index):
                d = np.zeros(len(z))
                d[i] = h
                H[:, j] = (gradient(z + d) - gradient(z - d)) / (2 * h)
            was = gradient(z)
            step = np.linalg.solve(H, -was)
            size = np.abs(step[: len(index) - extra]).max()
            share, before = min(1.0, 1.0 / size), z.copy()
            for _ in range(6):
                z[free] = before[free] + share * step
                now = gradient(z)
                if np.isfinite(now).all() and np.linalg.norm(now) < 1.5 * np.linalg.norm(was):
                    break
                share *= 0.5
            if size < 1e-8:
                return cartesian(z)
        raise RuntimeError("not converged")

    def hold(self, lam, kappa, start=None):
        size = self.X.size

        def whole(z, lam=lam, kappa=kappa):
            x, m = z[:size], z[size]
            stretch = lambda y: (lam * (1 + kappa * y), lam * kappa)
            e, g = self.energy(x, stretch, lambda _: (lam, np.zeros(size)))
            A, S, gA, gS = self.moment(x, self.bore)
            e -= self.p * lam * (A + kappa * S)
            g = g - self.p * lam * (gA + kappa * gS)
            _, So, _, gSo = self.moment(x, self.outer)
            return e + m * So, np.concatenate([g + m * gSo, [So]])

        x0 = self.X.ravel() if start is None else start
        z = self.solve(whole, x0, 1)
        d = 1e-6
        F = (whole(z, lam + d)[0] - whole(z, lam - d)[0]) / (2 * d) * 2
        M = (whole(z, lam, kappa + 1e-7)[0] - whole(z, lam, kappa - 1e-7)[0]) / 2e-7 * 2
        xo = z[:size].reshape(-1, 2)[self.outer]
        width, height = 2 * xo[:, 0].max(), xo[0, 1] - xo[-1, 1]
        return F, M, (width - height) / (width + height), z[:size]

    def press(self, omega, radius, start):
        size = self.X.size
        stiff = 100.0 * self.mu

        def whole(z, omega=omega):
            x = z
            stretch = lambda y: (omega * (radius + y), omega)

            def axis(x):
                A, S, gA, gS = self.moment(x, self.outer)
                return omega * (radius + S / A), omega * (gS / A - S / A**2 * gA)

            e, g = self.energy(x, stretch, axis)
            A, S, gA, gS = self.moment(x, self.bore)
            e -= self.p * omega * (radius * A + S)
            g = g - self.p * omega * (radius * gA + gS)
            o = self.outer
            under = np.minimum(x.reshape(-1, 2)[o, 1], 0)
            w = np.full(len(o), self.edge0[0])
            w[0] = w[-1] = 0.5 * self.edge0[0]
            e += (0.5 * stiff * w * under**2).sum()
            g = g.reshape(-1, 2).copy()
            g[o, 1] += stiff * w * under
            return e, g.ravel()

        z = self.solve(whole, start, origin=12.0)
        T = (whole(z, omega * (1 + 1e-6))[0] - whole(z, omega * (1 - 1e-6))[0]) / (2e-6 * omega) * 2
        A, S, _, _ = self.moment(z, self.outer)
        xo = z.reshape(-1, 2)[self.outer]
        return T, S / A, xo[0, 1] - xo[:, 1].min(), 2 * xo[:, 0].max(), z


MUSCLE = dict(outer=10.0, wall=2.0, angle_deg=30.0, k=300.0, mu=0.3, pressure=0.2)


def held(fixed, around):
    s = Section(**MUSCLE, fixed=fixed, around=around)
    for lam in (0.95, 0.85):
        x = before = s.hold(0.95, 0.0)[-1]
        for kappa in np.arange(0, 0.0201, 0.001):
            F, M, oval, new = s.hold(lam, kappa, 2 * x - before if kappa > 0.0015 else x)
            before, x = x, new
            if round(1e3 * kappa) % 5 == 0:
                print(f"hold fixed={fixed} λ {lam} κ {kappa:.3f}: F {F:.4f} M {M:.4f} oval {oval:.4f}", flush=True)


def pressed(fixed, around):
    """From a wide flat, where the muscle is nearly straight, to a narrow one."""
    s = Section(**MUSCLE, fixed=fixed, around=around)
    x = s.hold(0.85, 0.0, s.hold(0.95, 0.0)[-1])[-1].reshape(-1, 2).copy()
    x[:, 1] += -x[:, 1].min()
    x = x.ravel()
    for radius in (1000, 800, 600, 500, 450, 400, 350, 300, 270, 240, 220, 200, 180, 165, 150, 140, 130, 120, 110, 100, 95, 90, 85, 80):
        T, axis, _, _, x = s.press(0.85 / (radius + 12.0), radius, x)
        if radius in (500, 200, 120, 80):
            print(f"press fixed={fixed} R {radius}: T {T:.2f} axis {axis:.4f}", flush=True)


if __name__ == "__main__":
    for fixed in (False, True):
        pressed(fixed, 16)
    for fixed in (False, True):
        held(fixed, 16)
