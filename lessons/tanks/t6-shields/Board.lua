-- SPDX-License-Identifier: BSD-2-Clause
-- The board of this lesson. Digits are where the tanks begin; H and E are the chargers.
require "TankSoar";

TankSoar.Settings = {
    map = {
        "#E#2#H##",
        "### ####",
        "### ####",
        "### ####",
        "### ####",
        "###1   3",
        "########"
    },
    facing = { "north", "south", "west" },
    mostPacks = 0
};
