"""A muscle in a loss of JAX: pulls, pressures and contractions as functions that ``jax.grad``, ``jax.jvp``, ``jax.vmap`` and ``jax.jit`` take."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from ._errors import InputError, MckibbenError
from ._motion import Joint
from ._muscle import MEASURES, filled
from ._request import is_nan, numpy as np

if TYPE_CHECKING:
    import jax
    from typing_extensions import Unpack

    from ._api import Asking
    from ._muscle import Muscle
    from ._request import Array, Named

    # What JAX takes and differentiates.
    Function = Callable[..., jax.Array]

# Places and weights of differences of fourth order, about a point and from a point on.
_PLACES = (-2, 0), (-1, 1), (0, 2), (1, 3), (2, 4)
_WEIGHTS = (1, -25), (-8, 48), (0, -36), (8, 16), (-1, -3)
# Steps of differences are this share of a value, or of what is usual where that is less.
_STEP = 1e-3
_USUAL = {"force": (0.1, 0.2), "pressure": (100.0, 0.2), "contraction": (100.0, 0.1)}


class _Asked:
    """A number that is asked of a model, as a function of arrays and of θ."""

    # Numbers of the question, with what is usual of each, and which of them may be below zero.
    usual: Sequence[float]
    signed: int | None = 1
    names: Sequence[str] = ()
    # Values at points (the numbers of the question along their last axis) and one θ; where slopes are wanted with these, along an axis more at the end; with more
    # options.
    numbers: Callable[[Array, Array, bool, Named], Array]

    def __init__(self, muscle: Muscle, given: Named) -> None:
        self.options = options = dict(given)
        self.nan = is_nan(options.pop("errors", "raise"))
        # Which model it is, and whether there is one.
        self.has_second = not muscle._bound(options).is_elements
        # The axis that the derivatives of an order need: none, values and slopes, or second derivatives row by row.
        width = len(self.usual) + len(self.names)
        self.widths: Any = (), (1 + width,), (width, width)

    def second(self, points: Array, theta: Array) -> Array:
        """Second derivatives at one θ: differences of slopes, which closed forms have to their last digits. Slack muscles have none."""
        beyond = {"extrapolate": True, "two_sided": True}
        count = len(self.usual)
        rows: list[Array] = []
        for i, usual in enumerate((*self.usual, *abs(theta))):
            value = points[..., i] if i < count else theta[i - count]
            h = _STEP * (np.maximum(abs(value), usual) if usual else 1.0)
            # Not below zero: no gauge pressure is, and no pull.
            about = (value >= 2 * h) | (i >= count) | (i == self.signed)
            row: Any = 0.0
            for at, by in zip(_PLACES, _WEIGHTS):
                moved = points.copy(), theta.copy()
                moved[i >= count][..., i - count] += np.where(about, *at) * h
                slopes = self.numbers(*moved, True, beyond)
                row = (
                    row + (np.where(about, *by) / (12 * h))[..., None] * slopes[..., 1:]
                )
            rows.append(row)
        out = np.stack(rows, axis=-1)
        # What is equal differs by rounding alone.
        return 0.5 * (out + out.swapaxes(-1, -2))

    def one(self, points: Array, theta: Array, order: int) -> Array:
        """The values, or with axes more at the end derivatives of an order, at one θ."""
        try:
            if order == 2:
                return self.second(points, theta)
            return self.numbers(points, theta, order == 1, {})
        except MckibbenError:
            # A muscle that cannot be.
            if not self.nan:
                raise
            return np.full((*points.shape[:-1], *self.widths[order]), np.nan)

    def many(self, points: Any, theta: Any = (), *, order: int) -> Array:
        """The same where both may have axes of a batch in front, as many as θ has more than one."""
        points, theta = (np.asarray(v, dtype=np.float64) for v in (points, theta))
        if theta.size == theta.shape[-1]:
            return self.one(points, theta.reshape(-1), order)
        deep = theta.ndim - 1
        axes = np.broadcast_shapes(points.shape[:deep], theta.shape[:deep])
        points, theta = (
            np.broadcast_to(v, axes + v.shape[deep:]) for v in (points, theta)
        )
        parts = [self.one(points[i], theta[i], order) for i in np.ndindex(axes)]
        return np.stack(parts).reshape(axes + parts[0].shape)


class _OfMuscle(_Asked):
    """``force``, ``pressure`` or ``contraction`` of a muscle."""

    def __init__(
        self,
        muscle: Muscle,
        wanted: str,
        names: Sequence[str],
        given: Named,
    ) -> None:
        muscle._refuse(names, "wrt")
        self.muscle, self.wanted, self.names = muscle, wanted, names
        self.usual = _USUAL[wanted]
        self.signed = None if wanted == "contraction" else 1
        super().__init__(muscle, given)

    def numbers(self, points: Array, theta: Array, slopes: bool, more: Named) -> Array:
        values = dict(zip(self.names, theta.tolist()))
        measures = {name: value for name, value in values.items() if name in MEASURES}
        own = {name: value for name, value in values.items() if name not in MEASURES}
        muscle = self.muscle._of(self.muscle, **measures) if measures else self.muscle
        # One that is a value itself follows no measure.
        chain = muscle._chain(self.names, own) if slopes else None
        muscle = muscle.with_parameters(own) if own else muscle
        # Nothing is said of points: a sampler asks many.
        model = muscle._bound({**self.options, **more})
        pair = points[..., 0], points[..., 1]
        return filled(model, self.wanted, chain, *pair, self.nan)[0]

    def second(self, points: Array, theta: Array) -> Array:
        out = super().second(points, theta)
        if self.wanted == "force" and not self.options.get("two_sided"):
            out[self.one(points, theta, 0) == 0] = 0.0
        return out


class _OfJoint(_Asked):
    """The torque of a joint."""

    def __init__(self, joint: Joint, given: Named) -> None:
        muscles = joint._parts[1]
        self.joint, self.signed = joint, len(muscles)
        self.usual = *[0.1] * len(muscles), 20.0
        super().__init__(muscles[0], given)

    def numbers(self, points: Array, theta: Array, slopes: bool, more: Named) -> Array:
        how = "nan" if self.nan else "raise", {**self.options, **more}
        *pressures, angle = np.moveaxis(points, -1, 0)
        torque, rates, _ = self.joint._turned(pressures, angle, slopes, *how)
        rates[..., -1] *= np.pi / 180
        return np.concatenate([torque[..., None], rates], -1) if slopes else torque


def force(
    muscle: Muscle,
    wrt: Sequence[str] = (),
    **options: Unpack[Asking],
) -> Function:
    """F(P, ε; θ) of a muscle as a function of JAX with its first and second derivatives (``jax.custom_jvp``): ``f(pressure_mpa, contraction)``, or
    ``f(pressure_mpa, contraction, theta)`` with the values of the names in their order, or a dict of them, of the broadcast shape of pressures and contractions.

    Parameters
    ----------
    muscle
        The muscle.
    wrt
        Names of constants and measures of the muscle (see :attr:`Muscle.parameters`, in MPa, N/mm, mm, degrees) that the function takes as well, all others
        held; or measures as :meth:`Muscle.replace` has them: ``outer_diameter_mm``, ``wall_mm``, …; k of a named braid follows the diameter.
    errors
        ``raise``, or ``nan``: NaN at points without an answer and for muscles that cannot be, so that a sampler goes on.
    options
        Which model, and how it is asked, as in :meth:`Muscle.force`.

    Raises
    ------
    ValueError
        A muscle has no constant or measure of that name (:class:`InputError`).

    Examples
    --------
    >>> import jax, mckibben as mk
    >>> from mckibben.jax import force
    >>> f = force(mk.Muscle.prototype(), ["wall_mm"], model="universal")
    >>> by_wall = jax.grad(lambda wall: f(0.2, 0.1, {"wall_mm": wall}))
    >>> bool(by_wall(3.0) < 0)
    True
    """
    return _function(_OfMuscle(muscle, "force", wrt, options))


def pressure(
    muscle: Muscle,
    wrt: Sequence[str] = (),
    **options: Unpack[Asking],
) -> Function:
    """P(F, ε; θ) of a muscle: ``f(force_n, contraction)`` or ``f(force_n, contraction, theta)`` in MPa; arguments as in :func:`force`."""
    return _function(_OfMuscle(muscle, "pressure", wrt, options))


def contraction(
    muscle: Muscle,
    wrt: Sequence[str] = (),
    **options: Unpack[Asking],
) -> Function:
    """ε(F, P; θ) of a muscle: ``f(force_n, pressure_mpa)`` or ``f(force_n, pressure_mpa, theta)``; arguments as in :func:`force`."""
    return _function(_OfMuscle(muscle, "contraction", wrt, options))


def torque(joint: Joint, **options: Unpack[Asking]) -> Function:
    """τ(P, φ) of a joint with its first and second derivatives: ``f(pressures_mpa, angle_deg)`` in N m, with a pressure for each muscle; arguments as in :func:`force`."""
    return _function(_OfJoint(joint, options))


def _function(asked: _Asked) -> Function:
    # It takes its time, and need not be there.
    import jax
    import jax.numpy as jnp

    count = len(asked.usual)

    def of_order(order: int) -> jax.custom_jvp[Any]:
        def call(points: Any, theta: Any) -> Any:
            struct: Any = jax.ShapeDtypeStruct
            shape = *points.shape[:-1], *asked.widths[order]
            # Each array that is handed over takes its time.
            return jax.pure_callback(
                lambda *at: asked.many(*at, order=order).astype(points.dtype),
                struct(shape, points.dtype),
                *((points, theta) if asked.names else (points,)),
                vmap_method="expand_dims",
            )

        return jax.custom_jvp(call)

    value, slopes, curvatures = map(of_order, range(3))

    def along(rates: Any, points: Any, theta: Any) -> Any:
        """How what has these rates changes along a direction."""
        return (rates[..., :count] * points).sum(-1) + rates[..., count:] @ theta

    @value.defjvp
    def first(at: Any, by: Any) -> Any:
        found = slopes(*at)
        return found[..., 0], along(found[..., 1:], *by)

    @slopes.defjvp
    def second(at: Any, by: Any) -> Any:
        if not asked.has_second:
            raise NotImplementedError(
                "finite elements have first derivatives only: take universal"
            )
        found, (points, theta) = slopes(*at), by
        rows = along(curvatures(*at), points[..., None, :], theta)
        value = along(found[..., 1:], points, theta)
        return found, jnp.concatenate([value[..., None], rows], axis=-1)

    @curvatures.defjvp
    def third(at: Any, by: Any) -> Any:
        raise NotImplementedError("first and second derivatives only")

    def outer(first: Any, second: Any = 0.0, theta: Any = ()) -> jax.Array:
        if isinstance(theta, Mapping):
            is_all = set(theta) == set(asked.names)
            theta = [theta[name] for name in asked.names] if is_all else jnp.nan
        given = [first] if isinstance(asked, _OfMuscle) else first
        *given, theta = (jnp.asarray(v, dtype=float) for v in (*given, second, theta))
        if theta.shape != (len(asked.names),):
            raise InputError(f"the values of {[*asked.names]}", field="theta")
        points = jnp.stack(jnp.broadcast_arrays(*given), axis=-1)
        found: jax.Array = value(points, theta)
        return found

    return outer
