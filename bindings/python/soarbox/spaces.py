# SPDX-License-Identifier: BSD-2-Clause
"""Spaces of actions and observations, with the interface of Gymnasium's spaces. They do not need Gymnasium."""
from __future__ import annotations

import math
import operator
import random
from typing import Any, List, Optional, Sequence, Tuple, Union

Number = Union[int, float]


def array(values: Sequence[float]) -> Any:
    """Numbers as a numpy array of the type float32, or as a tuple of floats if there is no numpy."""
    try:
        import numpy
    except ImportError:
        return tuple(float(value) for value in values)
    return numpy.array(values, dtype=numpy.float32)


class Space:
    """Base of all spaces. `sample` draws from a separate random stream; `seed` restarts it."""

    shape: Tuple[int, ...] = ()
    dtype: Any = None

    def __init__(self, seed: Optional[int] = None):
        self._random = random.Random(seed)

    def seed(self, seed: Optional[int] = None) -> List[Optional[int]]:
        """Restarts the stream of samples with this seed; without a seed, at a random place."""
        self._random = random.Random(seed)
        return [seed]

    def sample(self) -> Any:
        raise NotImplementedError

    def contains(self, x: Any) -> bool:
        """Whether the space contains this value."""
        raise NotImplementedError

    def __contains__(self, x: Any) -> bool:
        return self.contains(x)


class Discrete(Space):
    """The `n` whole numbers from `start` on."""

    dtype = int

    def __init__(self, n: int, seed: Optional[int] = None, start: int = 0):
        super().__init__(seed)
        if not isinstance(n, int) or isinstance(n, bool) or n < 1:
            raise ValueError(f"n is a whole number from 1, not {n!r}")
        self.n = n
        self.start = start

    def sample(self) -> int:
        return self.start + self._random.randrange(self.n)

    def contains(self, x: Any) -> bool:
        if isinstance(x, bool):
            return False
        try:
            return self.start <= operator.index(x) < self.start + self.n
        except TypeError:
            return False

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Discrete) and (self.n, self.start) == (other.n, other.start)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"Discrete({self.n}, start={self.start})" if self.start else f"Discrete({self.n})"


class Box(Space):
    """A vector of numbers, each between its bounds. `low` and `high` are one number for all elements, or one for each.

    Both become numpy arrays, or tuples if there is no numpy.
    """

    dtype: Any = "float32"

    def __init__(self, low: Union[Number, Sequence[Number]], high: Union[Number, Sequence[Number]],
                 shape: Optional[Tuple[int, ...]] = None, seed: Optional[int] = None):
        super().__init__(seed)
        sizes = {len(bound) for bound in (low, high) if not isinstance(bound, (int, float))}
        if shape is not None:
            if len(shape) != 1:
                raise ValueError(f"a Box is a row of numbers: its shape is (n,), not {shape!r}")
            sizes.add(shape[0])
        if len(sizes) != 1:
            raise ValueError("low, high and shape must agree about how many numbers there are")
        self.shape = (sizes.pop(),)
        self._low = self._row(low)
        self._high = self._row(high)
        if any(not lowest <= highest for lowest, highest in zip(self._low, self._high)):
            raise ValueError("low must not be above high")
        self.low = array(self._low)
        self.high = array(self._high)

    def _row(self, bound: Union[Number, Sequence[Number]]) -> List[float]:
        if isinstance(bound, (int, float)):
            return [float(bound)] * self.shape[0]
        return [float(number) for number in bound]

    def sample(self) -> Any:
        """Uniform between two finite bounds; exponential if one is infinite; normal around 0 if both are."""
        return array([self._draw(lowest, highest) for lowest, highest in zip(self._low, self._high)])

    def _draw(self, low: float, high: float) -> float:
        if math.isfinite(low) and math.isfinite(high):
            return self._random.uniform(low, high)
        if math.isfinite(low):
            return low + self._random.expovariate(1)
        if math.isfinite(high):
            return high - self._random.expovariate(1)
        return self._random.gauss(0, 1)

    def contains(self, x: Any) -> bool:
        try:
            numbers = [float(number) for number in x]
        except (TypeError, ValueError):
            return False
        # Compares with the rounded bounds, because numpy rounds samples to float32, too.
        return len(numbers) == self.shape[0] and all(
            lowest <= number <= highest for lowest, number, highest in zip(self.low, numbers, self.high))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Box) and (self._low, self._high) == (other._low, other._high)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"Box({min(self._low)}, {max(self._high)}, {self.shape}, {self.dtype})"
