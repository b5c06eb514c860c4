# SPDX-License-Identifier: BSD-2-Clause
"""What actions and observations may be, shaped as Gymnasium's spaces are. Nothing of Gymnasium is needed."""
from __future__ import annotations

import math
import operator
import random
from typing import Any, List, Optional, Sequence, Tuple, Union

Number = Union[int, float]


def array(values: Sequence[float]) -> Any:
    """Numbers as a numpy array of the type float32; as a tuple of floats where there is no numpy."""
    try:
        import numpy
    except ImportError:
        return tuple(float(value) for value in values)
    return numpy.array(values, dtype=numpy.float32)


class Space:
    """What all spaces have. `sample` draws from a stream of its own, which `seed` begins again."""

    shape: Tuple[int, ...] = ()
    dtype: Any = None

    def __init__(self, seed: Optional[int] = None):
        self._random = random.Random(seed)

    def seed(self, seed: Optional[int] = None) -> List[Optional[int]]:
        """Begins the stream of samples again; without a number, anywhere."""
        self._random = random.Random(seed)
        return [seed]

    def sample(self) -> Any:
        raise NotImplementedError

    def contains(self, x: Any) -> bool:
        """Whether this is one of the values."""
        raise NotImplementedError

    def __contains__(self, x: Any) -> bool:
        return self.contains(x)


class Discrete(Space):
    """The whole numbers from `start` on, `n` of them."""

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
    """Numbers in a row, each between its bounds. `low` and `high` are one number for all, or one for each.

    Both are numpy arrays where numpy is there, and tuples where it is not.
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
        """Even between two bounds; where one is infinite, mostly near the other one; where both are, near 0."""
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
        # The bounds are compared as they are published: numpy rounds them to float32, as it rounds samples.
        return len(numbers) == self.shape[0] and all(
            lowest <= number <= highest for lowest, number, highest in zip(self.low, numbers, self.high))

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Box) and (self._low, self._high) == (other._low, other._high)

    __hash__ = None  # type: ignore[assignment]

    def __repr__(self) -> str:
        return f"Box({min(self._low)}, {max(self._high)}, {self.shape}, {self.dtype})"
