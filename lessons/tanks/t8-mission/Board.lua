-- SPDX-License-Identifier: BSD-2-Clause
-- The board of this lesson. Digits are where the tanks begin; H and E are the chargers.
require "TankSoar";

TankSoar.Settings = {
    map = {
        "H   #    ",
        "  #   #  ",
        "    1    ",
        " ##   ## ",
        "         ",
        "  #   #  ",
        "    2   E"
    },
    mostPacks = 0
};
