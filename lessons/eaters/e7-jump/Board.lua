-- SPDX-License-Identifier: BSD-2-Clause
-- The board of this lesson. 1 is where the eater begins.
require "Eaters";

Eaters.Settings = {
    map = {
        "#########",
        "#1#*#*#*#",
        "#..######",
        "#########"
    }
};
