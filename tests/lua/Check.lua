-- SPDX-License-Identifier: BSD-2-Clause
-- For the tests of the Lua library. A test is a function in a table.

function Check(condition, what)
    if (not condition) then
        error(what or "the condition does not hold", 2);
    end
end

function CheckEqual(wanted, found)
    if (wanted ~= found) then
        error("wanted " .. tostring(wanted) .. ", found " .. tostring(found), 2);
    end
end

function CheckNear(wanted, found, tolerance)
    if (math.abs(wanted - found) > (tolerance or 0.001)) then
        error("wanted " .. wanted .. ", found " .. found, 2);
    end
end

-- Runs the functions of a table. Prints each failure, and then the number of passed tests.
function RunTests(tests)
    local passed = 0;
    for name, test in pairs(tests) do
        local ok, message = pcall(test);
        if (ok) then
            passed = passed + 1;
        else
            print("FAILED " .. name .. ": " .. tostring(message));
        end
    end
    print("passed " .. passed);
end
