-- SPDX-License-Identifier: BSD-2-Clause
-- The board of this lesson. 1 is where the eater begins. The food below cannot be reached, so that the eater has to
-- turn back in the dead end.
require "Eaters";

Eaters.Settings = {
    map = {
        "######",
        "#1   #",
        "#### #",
        "#### #",
        "#### #",
        "#### #",
        "####.#",
        "######",
        "#.####",
        "######"
    }
};
