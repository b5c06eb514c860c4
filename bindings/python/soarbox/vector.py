# SPDX-License-Identifier: BSD-2-Clause
"""Many environments at once, on all cores."""
from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor
from typing import Any, Callable, Dict, List, Optional, Sequence, Tuple, Union

from .environment import Environment


class VectorEnvironment:
    """`count` environments that take their steps at the same time, with the functions of a Gymnasium vector environment.

    `make` returns a new Environment; it is called once for each. Each has an engine of its own, so that steps use all
    cores; one Python process drives them all.

    Observations, rewards and flags come as numpy arrays with a row for each environment, or as tuples if there is no
    numpy. An environment whose episode is over begins the next one in the next step, whose action it ignores: that step
    returns the first observation of the episode and the reward 0 (Gymnasium's next-step mode).

    The same seeds and actions give the same values, however many cores there are.
    """

    metadata: Dict[str, Any] = {"autoreset_mode": "next_step"}

    def __init__(self, make: Callable[[], Environment], count: int):
        if not isinstance(count, int) or isinstance(count, bool) or count < 1:
            raise TypeError(f"the number of environments is a whole number from 1, not {count!r}")
        self.num_envs = count
        self._pool = ThreadPoolExecutor(count)
        self.environments: List[Environment] = []
        try:
            futures = [self._pool.submit(make) for _ in range(count)]
            problem = None
            for future in futures:
                try:
                    self.environments.append(future.result())
                except BaseException as error:  # The others are closed before it is raised.
                    problem = problem or error
            if problem is not None:
                raise problem
        except BaseException:
            self.close()
            raise
        self.single_action_space = self.environments[0].action_space
        self.single_observation_space = self.environments[0].observation_space
        self._is_over = [False] * count

    def reset(self, *, seed: Union[None, int, Sequence[Optional[int]]] = None,
              options: Optional[Dict[str, Any]] = None) -> Tuple[Any, Dict[str, Any]]:
        """Begins an episode in each environment. With one seed, environment i gets seed + i."""
        if seed is None or isinstance(seed, int):
            seeds: Sequence[Optional[int]] = [None if seed is None else seed + i for i in range(self.num_envs)]
        else:
            seeds = list(seed)
        if len(seeds) != self.num_envs:
            raise ValueError(f"there are {len(seeds)} seeds for {self.num_envs} environments")
        results = self._each(lambda i: self.environments[i].reset(seed=seeds[i], options=options))
        self._is_over = [False] * self.num_envs
        return _rows([observation for observation, _ in results]), _infos([info for _, info in results])

    def step(self, actions: Sequence[Any]) -> Tuple[Any, Any, Any, Any, Dict[str, Any]]:
        """Gives each agent the order of its action, and runs all worlds for one step."""
        if len(actions) != self.num_envs:
            raise ValueError(f"there are {len(actions)} actions for {self.num_envs} environments")

        def one(i: int) -> Tuple[Any, float, bool, bool, Dict[str, Any]]:
            if self._is_over[i]:
                observation, info = self.environments[i].reset()
                return observation, 0.0, False, False, info
            return self.environments[i].step(actions[i])

        results = self._each(one)
        self._is_over = [ended or truncated for _, _, ended, truncated, _ in results]
        observations, rewards, ended, truncated, infos = zip(*results)
        return (_rows(observations), _row(rewards, "float64"), _row(ended, "bool"), _row(truncated, "bool"), _infos(infos))

    def close(self) -> None:
        """Ends all worlds. May be called twice."""
        for environment in self.environments:
            environment.close()
        self._pool.shutdown()

    def __len__(self) -> int:
        return self.num_envs

    def __enter__(self) -> "VectorEnvironment":
        return self

    def __exit__(self, *ignored: object) -> None:
        self.close()

    def _each(self, do: Callable[[int], Any]) -> List[Any]:
        """Threads wait for the engines, which compute."""
        return list(self._pool.map(do, range(self.num_envs)))


def _row(values: Sequence[Any], kind: str) -> Any:
    try:
        import numpy
    except ImportError:
        return tuple(values)
    return numpy.array(values, dtype=kind)


def _rows(observations: Sequence[Any]) -> Any:
    try:
        import numpy
    except ImportError:
        return tuple(observations)
    return numpy.stack([numpy.asarray(observation) for observation in observations])


def _infos(infos: Sequence[Dict[str, Any]]) -> Dict[str, Any]:
    """A row for each entry."""
    names = dict.fromkeys(name for info in infos for name in info)
    return {name: [info.get(name) for info in infos] for name in names}
