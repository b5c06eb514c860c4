# SPDX-License-Identifier: BSD-2-Clause
"""A tabular learner: anna learns to walk to the north end of a hallway and to stay there. Usage: q_learning.py [EPISODES]

Q-learning over the cell in which she is and three actions. It prints the return of each episode, which grows.
"""
import random
import sys

import soarbox

RATE, DISCOUNT, CURIOSITY = 0.3, 0.95, 0.3
ACTIONS = ["stop", ("move-to", {"waypoint": "north"}), ("move-to", {"waypoint": "south"})]


def cell(observation):
    """The state of the learner: 2 m of the hallway."""
    return round(float(observation[0]) / 2)


def main(episodes):
    environment = soarbox.Environment(
        "soar_hallway", "anna", seed=1, actions=ACTIONS, observe=["self.position.z"],
        reward=lambda agent: -agent.percepts["self"]["position"]["z"] / 10, ticks=30, most_steps=30)
    chance, values, returns = random.Random(1), {}, []
    for episode in range(episodes):
        curiosity = CURIOSITY * (1 - episode / episodes)  # It tries less and less.
        observation, _info = environment.reset(seed=1)
        state, total, over = cell(observation), 0.0, False
        while not over:
            row = values.setdefault(state, [0.0] * len(ACTIONS))
            action = chance.randrange(len(ACTIONS)) if chance.random() < curiosity else row.index(max(row))
            observation, reward, terminated, truncated, _info = environment.step(action)
            over, after = terminated or truncated, cell(observation)
            best = 0.0 if terminated else max(values.setdefault(after, [0.0] * len(ACTIONS)))
            row[action] += RATE * (reward + DISCOUNT * best - row[action])
            state, total = after, total + reward
        returns.append(total)
        print(f"episode {episode + 1}: return {total:.1f}", flush=True)
    environment.close()
    return returns


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 20)
