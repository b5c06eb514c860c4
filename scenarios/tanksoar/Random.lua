-- SPDX-License-Identifier: BSD-2-Clause
require "TankSoar";
TankSoar.Settings = { map = "random" };
