// SPDX-License-Identifier: BSD-2-Clause
#include "script/lua_machine.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "script/script_path.h"
#include "world/world_random.h"

namespace soarbox::script {
namespace {

class StreamRandom final : public RandomSource {
 public:
  explicit StreamRandom(std::uint64_t seed) : stream_(seed) {}
  double Unit() override { return stream_.UnitDouble(); }
  void Reseed(std::int64_t number) override { stream_.Reseed(static_cast<std::uint64_t>(number)); }

 private:
  world::RandomStream stream_;
};

class Lines final : public PrintSink {
 public:
  void OnPrint(std::string_view, std::string_view text) override { lines.emplace_back(text); }
  std::vector<std::string> lines;
};

/// A machine with its own folder, and its output.
class MachineTest : public testing::Test {
 protected:
  MachineTest() {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("soarbox_machine_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_ / "own");
    std::filesystem::create_directories(folder_ / "library");
    path_ = std::make_unique<ScriptPath>(std::vector{folder_ / "own", folder_ / "library"});
    Start({});
  }
  ~MachineTest() override { std::filesystem::remove_all(folder_); }

  void Start(MachineLimits limits, std::uint64_t seed = 1) {
    machine_.reset();
    random_ = std::make_unique<StreamRandom>(seed);
    MachineSetup setup;
    setup.script = "test.lua";
    setup.limits = limits;
    setup.path = path_.get();
    setup.random = random_.get();
    setup.print = &lines_;
    machine_ = std::make_unique<LuaMachine>(std::move(setup));
  }
  void Write(const std::string& name, std::string_view text) { std::ofstream(folder_ / name) << text; }

  /// Returns the output, lines joined by "|"; "error: ..." if the script failed.
  std::string Run(std::string_view text) {
    lines_.lines.clear();
    const auto error = machine_->RunText(text, "test.lua");
    if (error) return "error: " + error->diagnostic.message;
    std::string joined;
    for (const std::string& line : lines_.lines) joined += (joined.empty() ? "" : "|") + line;
    return joined;
  }

  std::filesystem::path folder_;
  std::unique_ptr<ScriptPath> path_;
  std::unique_ptr<StreamRandom> random_;
  Lines lines_;
  std::unique_ptr<LuaMachine> machine_;
};

TEST_F(MachineTest, SpeaksLua51) {
  const std::pair<const char*, const char*> snippets[] = {
      {"print(string.format('%d', 1.7), #{1,2,3}, 7 % 3)", "1\t3\t1"},
      {"local t = {1}; table.insert(t, nil); print(#t)", "1"},
      {"local function f(a, a) return a end print(f(1, 2))", "2"},
      {"print(unpack({1, 2}))", "1\t2"},
      {"print(1e15, 0.1, 10/2)", "1e+15\t0.1\t5"},
      {"print(string.find('numpad_3_key', '^[numpad_]*3_key$'), string.find('f3_key', '^[numpad_]*3_key$'))", "1\tnil"},
      {"print(pcall(error, 'x'))", "false\tx"},
      {"print(math.random(3, 3), math.random(1))", "3\t1"},
      {"local c = coroutine.wrap(function() coroutine.yield(1) end) print(c())", "1"},
  };
  for (const auto& [script, printed] : snippets) EXPECT_EQ(Run(script), printed) << script;
}

TEST_F(MachineTest, OffersNothingThatReachesOutside) {
  EXPECT_EQ(Run("print(io, os.execute, debug.getinfo, ffi, jit, dofile, loadfile, string.dump, newproxy, module)"),
            "nil\tnil\tnil\tnil\tnil\tnil\tnil\tnil\tnil\tnil");
  EXPECT_EQ(Run("print(loadstring('return 1')(), load(function() return nil end)())"), "1");
  EXPECT_EQ(Run("print((loadstring('\\27LJ')))"), "nil");
  EXPECT_NE(Run("require 'os'").find("error: no such script file: \"os.lua\""), std::string::npos);
  EXPECT_EQ(Run("print(getmetatable('').__index == string, package.path)"), "true\tnil");
}

TEST_F(MachineTest, TellsTheTimeOfTheSimulation) {
  EXPECT_EQ(Run("print(os.clock(), os.time(), os.date('%Y-%m-%d %H:%M:%S'), os.getenv('HOME'))"),
            "0\t946684800\t2000-01-01 00:00:00\tnil");
  EXPECT_EQ(Run("print(os.time{year = 1970, month = 1, day = 1, hour = 0}, os.time{year = 2026, month = 14, day = 1})"),
            "0\t1801483200");
  EXPECT_EQ(Run("local d = os.date('!*t', 86399) print(d.year, d.hour, d.sec, d.wday, d.yday, d.isdst)"),
            "1970\t23\t59\t5\t1\tfalse");
  EXPECT_EQ(Run("print(os.difftime(7, 3), os.date('100%% %y', 0))"), "4\t100% 70");
  EXPECT_NE(Run("os.time{year = 2000, month = 1}").find("field 'day' missing in date table"), std::string::npos);
  EXPECT_NE(Run("os.time{year = 1e300, month = 1, day = 1}").find("out of range"), std::string::npos);
  EXPECT_NE(Run("os.date('%Q')").find("'%' is followed by a letter that no date has"), std::string::npos);
  EXPECT_NE(Run("os.date('%')").find("'%' is followed by a letter that no date has"), std::string::npos);
  EXPECT_NE(Run("os.date('%c', 0 / 0)").find("out of range"), std::string::npos);
}

TEST_F(MachineTest, VisitsTablesInTheOrderOfTheirKeys) {
  const char* mixed = "local t = {zebra=1, ape=2, [10]=3, [2.5]=4, [true]=5, [false]=6, 'one', 'two'}\n";
  EXPECT_EQ(Run(std::string(mixed) + "for k in pairs(t) do print(k) end"), "1|2|2.5|10|ape|zebra|false|true");
  EXPECT_EQ(Run(std::string(mixed) + "for k in next, t do print(k) end"), "1|2|2.5|10|ape|zebra|false|true");
  EXPECT_EQ(Run(std::string(mixed) + "table.foreach(t, function(k) print(k) end)"), "1|2|2.5|10|ape|zebra|false|true");
  EXPECT_EQ(Run("print(next({}), next({5}), type(next))"), "nil\t1\tfunction");
}

TEST_F(MachineTest, VisitsKeysThatAreObjectsInTheOrderOfTheirMaking) {
  EXPECT_EQ(Run("local a, b, c = {}, {}, {}\n"
                "local f, g = function() end, function() return a end\n"
                "local names = {[g]='g', [c]='c', [a]='a', [f]='f', [b]='b'}\n"
                "local order = '' for k, v in pairs(names) do order = order .. v end print(order)"),
            "abcfg");
}

TEST_F(MachineTest, SkipsFieldsThatALoopRemoves) {
  EXPECT_EQ(Run("local t = {a=1, b=2, c=3} for k in pairs(t) do t.b = nil; t.d = 4; print(k) end"), "a|c");
}

TEST_F(MachineTest, PrintsObjectsWithoutTheirAddresses) {
  const char* script = "local t = {} print(t, print) print(string.format('%s', t), tostring(t))";
  const std::string first = Run(script);
  EXPECT_EQ(first, "table: 0x00000001\tfunction: 0x00000002|table: 0x00000001\ttable: 0x00000001");
  Start({});
  EXPECT_EQ(Run(script), first);
}

TEST_F(MachineTest, CutsFractionalRandomLimitsAsLua51Does) {
  EXPECT_EQ(Run("local low, high = 100, 0\n"
                "for i = 1, 2000 do local r = math.random(5.95, 8.05) low = math.min(low, r) high = math.max(high, r)\n"
                "assert(r == math.floor(r)) end print(low, high)"),
            "5\t8");
  EXPECT_EQ(Run("for i = 1, 1000 do local r = math.random() assert(r >= 0 and r < 1) end print('ok')"), "ok");
  EXPECT_NE(Run("math.random(0)").find("interval is empty"), std::string::npos);
}

TEST_F(MachineTest, DrawsTheSameNumbersFromTheSameSeedOnly) {
  const char* script = "print(math.random(1, 1000000), math.random(1, 1000000))";
  const std::string first = Run(script);
  Start({}, 1);
  EXPECT_EQ(Run(script), first);
  Start({}, 2);
  EXPECT_NE(Run(script), first);
  EXPECT_EQ(Run("math.randomseed(7) local a = math.random() math.randomseed(7) print(a == math.random())"), "true");
}

TEST_F(MachineTest, ReportsCompileErrorsWithFileLineAndSource) {
  Write("own/Broken.lua", "local a = 1\nlocal b = = 2\n");
  const auto error = machine_->RunFile("Broken.lua");
  ASSERT_TRUE(error);
  EXPECT_EQ(error->diagnostic.file, (folder_ / "own" / "Broken.lua").string());
  EXPECT_EQ(error->diagnostic.line, 2);
  EXPECT_EQ(error->diagnostic.excerpt, "local b = = 2");
  EXPECT_EQ(error->diagnostic.message, "unexpected symbol near '='");
}

TEST_F(MachineTest, ReportsRunTimeErrorsWithTheirCalls) {
  Write("own/Fails.lua",
        "local function Inner(x)\n  return x.field\nend\nfunction Outer()\n  Inner(nil)\n  return 1\nend\nOuter()\n");
  const auto error = machine_->RunFile("Fails.lua");
  ASSERT_TRUE(error);
  EXPECT_EQ(error->diagnostic.line, 2);
  EXPECT_EQ(error->diagnostic.message, "attempt to index local 'x' (a nil value)");
  EXPECT_EQ(
      error->traceback,
      "  Fails.lua:2: in function 'Inner'\n  Fails.lua:5: in function 'Outer'\n  Fails.lua:8: in the main chunk\n");
}

TEST_F(MachineTest, ReportsErrorsWithoutAPlaceWhereTheyWereRaised) {
  for (const auto& [script, message] :
       {std::pair{"\n\nerror('plain', 0)", "plain"}, std::pair{"\n\nerror({})", "the error is a table value"}}) {
    const auto error = machine_->RunText(script, "test.lua");
    ASSERT_TRUE(error) << script;
    EXPECT_EQ(error->diagnostic.line, 3);
    EXPECT_EQ(error->diagnostic.file, "test.lua");
    EXPECT_EQ(error->diagnostic.message, message);
  }
}

TEST_F(MachineTest, ReportsAMissingFileWithANearMiss) {
  Write("library/GUI.lua", "");
  const auto error = machine_->RunFile("GIU.lua");
  ASSERT_TRUE(error);
  EXPECT_EQ(error->diagnostic.message, "no such script file: \"GIU.lua\"");
  EXPECT_EQ(error->diagnostic.hint, "did you mean \"GUI.lua\"?");
  EXPECT_TRUE(machine_->RunFile("../secret.lua"));
  EXPECT_EQ(machine_->RunFile(std::string(1 << 20, 'x'))->diagnostic.message, "a script's name has 1000 bytes at most");
  EXPECT_TRUE(machine_->RunFile("/etc/passwd"));
  EXPECT_TRUE(machine_->RunFile(""));
}

TEST_F(MachineTest, RequiresEachModuleOncePreferringTheOwnFolderAndIgnoringCase) {
  Write("own/Both.lua", "print('own')");
  Write("library/Both.lua", "print('library')");
  Write("library/Utilities.lua", "Value = 7");
  EXPECT_EQ(Run("require 'Both' require 'Both'"), "own");
  EXPECT_EQ(Run("print(require 'utilities', Value)"), "nil\t7");
}

TEST_F(MachineTest, ReportsErrorsOfModulesInTheirOwnFile) {
  Write("library/Bad.lua", "\n\nlocal x = nil .. 'text'");
  Write("own/Circle.lua", "require 'Circle'");
  const auto error = machine_->RunText("require 'Bad'", "test.lua");
  ASSERT_TRUE(error);
  EXPECT_EQ(error->diagnostic.file, (folder_ / "library" / "Bad.lua").string());
  EXPECT_EQ(error->diagnostic.line, 3);
  EXPECT_EQ(Run("local ok, first = pcall(require, 'Bad') print(first == select(2, pcall(require, 'Bad')))"), "true");
  EXPECT_EQ(Run("require 'Circle'"), "error: module 'Circle' requires itself, directly or through others");
  EXPECT_EQ(Run("require 'Nowhere'").substr(0, 46), "error: no such script file: \"Nowhere.lua\" (sea");
}

TEST_F(MachineTest, StopsEndlessLoopsAtTheSameInstructionEachTime) {
  const MachineLimits limits{std::size_t{16} << 20, 1'000'000};
  std::string counts[2];
  for (std::string& count : counts) {
    Start(limits);
    const std::string stopped = Run("n = 0 while true do n = n + 1 end");
    EXPECT_NE(stopped.find("is there an endless loop?"), std::string::npos) << stopped;
    count = Run("print(n)");
  }
  EXPECT_EQ(counts[0], counts[1]);
  EXPECT_GT(std::stoll(counts[0]), 100'000);
}

TEST_F(MachineTest, EachFunctionOfTheLibraryPaysForItsWorstCase) {
  // A budget of 2 million instructions ends each loop after at most this number of calls, because a call is charged for
  // about as many instructions as its work takes.
  struct Case {
    const char *prepare, *call;
    int most_calls;
  };
  const Case cases[] = {
      {"s = string.rep('a', 200000) p = string.rep('a', 100000) .. 'b'", "s:find(p, 1, true)", 200},
      {"s = string.rep('a', 200000)", "s:find('b', 1, true)", 200},
      {"s = string.rep('a', 2000)", "s:find('a-a-a-b')", 100},
      {"s = string.rep('a', 20000)", "s:gsub('a', function() end)", 20},
      {"s = string.rep('a', 2000) r = string.rep('b', 10000)", "s:gsub('a', r)", 5},
      {"t = {}", "table.insert(t, -100000, 1) t = {}", 20},
      {"t = {} for i = 1, 10000 do t[i] = i end", "table.insert(t, 1, 0) table.remove(t, 1)", 5000},
      {"t = {1}", "table.remove(t, -100000)", 20},
      {"t = {} for i = 1, 1000 do t[i] = string.rep('a', 10000) .. i end", "table.sort(t)", 3},
      {"t = {} s = string.rep('a', 100000) for i = 1, 100 do t[i] = s end", "table.concat(t)", 20},
      {"t = {} for i = 1, 1000 do t[i] = '' end s = string.rep('a', 10000)", "table.concat(t, s)", 20},
      {"", "string.rep('a', 1000000)", 100},
      {"s = string.rep('a', 100000)", "string.rep('', 100, s)", 20},
      {"s = string.rep('a', 1000000)", "s:upper()", 100},
      {"s = string.rep('a', 1000000)", "s:reverse()", 100},
      {"t = {} for i = 1, 10000 do t[i * 1.5] = i end", "table.maxn(t)", 1000},
      {"t = {} for i = 1, 10000 do t[i * 1.5] = i end", "for k in pairs(t) do break end", 1000},
  };
  for (const Case& each : cases) {
    Start({std::size_t{64} << 20, 2'000'000});
    ASSERT_EQ(Run(std::string("calls = 0 ") + each.prepare), "") << each.prepare;
    const std::string error = Run(std::string("while true do calls = calls + 1 ") + each.call + " end");
    EXPECT_NE(error.find("error: "), std::string::npos) << each.call;
    const std::string calls = Run("print(calls)");
    EXPECT_LE(std::stoi(calls), each.most_calls) << each.call;
  }
}

TEST_F(MachineTest, DoesNotLetAScriptCatchTheEndOfItsBudget) {
  Start({std::size_t{16} << 20, 1'000'000});
  EXPECT_NE(Run("while true do pcall(function() while true do end end) end").find("endless loop"), std::string::npos);
  EXPECT_NE(Run("local f f = function() while true do end end while true do xpcall(f, f) end").find("error"),
            std::string::npos);
  EXPECT_NE(Run("coroutine.wrap(function() while true do end end)()").find("endless loop"), std::string::npos);
  EXPECT_EQ(Run("print('still works')"), "still works");
  EXPECT_EQ(Run("print(xpcall(error, function(e) return 'handled ' .. e end, 'x'))"), "false\thandled x");
}

TEST_F(MachineTest, MatchesPatternsAsLua51Does) {
  const std::pair<const char*, const char*> snippets[] = {
      {"print(string.find('key = value', '(%w+)%s*=%s*(%w+)'))", "1\t11\tkey\tvalue"},
      {"print(string.find('a.b', '.', 1, true), string.find('abc', 'c', -1), string.find('', ''))", "2\t3\t1\t0"},
      {"print(string.match('THE (quick) fox', '%((%a+)%)'), ('x()'):match('()%b()'))", "quick\t2"},
      {"print(string.gsub('hello world', '(o)(.?)', '<%2%1%0%%>'))", "hell< oo %>w<roor%>ld\t2"},
      {"print(string.gsub('abc', '%w*', 'x'), string.gsub('$name is $age', '%$(%w+)', {name = 'Bo', age = 7}))",
       "xx\tBo is 7\t2"},
      {"print((string.gsub('THE (quick) fox', '%f[%a]%a+', string.lower)))", "the (quick) fox"},
      {"local t = {} for k, v in string.gmatch('a=1, b=2', '(%w+)=(%w+)') do t[#t + 1] = k .. v end "
       "print(table.concat(t, ' '))",
       "a1 b2"},
      {"print(pcall(string.find, 'a', '[a'))", "false\tmalformed pattern (missing ']')"},
      {"print(pcall(string.rep, 'x', -1), pcall(string.gsub, 'a', '(', ''))", "true\tfalse\tunfinished capture"},
  };
  for (const auto& [script, printed] : snippets) EXPECT_EQ(Run(script), printed) << script;
}

TEST_F(MachineTest, StopsPatternsThatTakeForEver) {
  Start({std::size_t{16} << 20, 1'000'000});
  EXPECT_NE(Run("string.find(('a'):rep(30000), '.-.-.-b')").find("endless loop"), std::string::npos);
  EXPECT_NE(Run("string.gsub(('a'):rep(40), ('a?'):rep(40) .. ('a'):rep(40) .. 'b', '')").find("endless loop"),
            std::string::npos);
  EXPECT_NE(Run("string.find(('a'):rep(100000), ('a*'):rep(500))").find("pattern too complex"), std::string::npos);
}

TEST_F(MachineTest, LimitsMemoryAndRecovers) {
  Start({std::size_t{4} << 20, 50'000'000});
  const std::string expected = "error: the script needs more than its limit of 4096 KB of memory";
  EXPECT_EQ(Run("local t = {} while true do t[#t + 1] = {} end"), expected);
  EXPECT_EQ(Run("local s = 'x' while true do s = s .. s end"), expected);
  EXPECT_EQ(Run("return ('x'):rep(1e9)"), expected);
  EXPECT_EQ(Run("print('still works')"), "still works");
}

TEST_F(MachineTest, SurvivesEndlessRecursion) {
  EXPECT_NE(Run("local function f() return 1 + f() end f()").find("stack overflow"), std::string::npos);
  EXPECT_EQ(Run("print('still works')"), "still works");
}

TEST_F(MachineTest, IsHarmlessWhenThereIsNoMemoryAtAll) {
  Start({1000, 1000});
  EXPECT_NE(Run("print(1)").find("not enough memory to start"), std::string::npos);
}

TEST_F(MachineTest, AFileIsParsedOnceForAllMachinesAndKeepsItsLines) {
  Write("own/Shared.lua",
        "local shared = 0\nfunction Next()\n  shared = shared + 1\n  if shared > 2 then error('too far') end\n"
        "  return shared\nend\nkeys = { a = 1, b = 2, [3] = 'c' }\n");
  const ScriptSource& source = *path_->Load("Shared.lua").value();
  EXPECT_TRUE(source.compiled.empty());
  std::string compiled;
  for (int machine = 0; machine < 3; ++machine) {
    Start({});
    ASSERT_FALSE(machine_->RunFile("Shared.lua"));
    if (machine == 0) compiled = source.compiled;
    EXPECT_EQ(source.compiled, compiled);
    EXPECT_FALSE(compiled.empty());
    // Each machine has its own variables, and errors name the place in the file.
    EXPECT_EQ(Run("print(Next(), Next(), keys.a + keys.b, keys[3])"), "1\t2\t3\tc");
    const auto error = machine_->RunText("Next()", "test.lua");
    ASSERT_TRUE(error);
    EXPECT_EQ(error->diagnostic.line, 4);
    EXPECT_EQ(error->diagnostic.message, "too far");
    EXPECT_NE(error->diagnostic.file.find("Shared.lua"), std::string::npos);
  }
}

// Each machine hashes strings differently, as each process does.
TEST_F(MachineTest, GarbageGoesAtTheSameInstructionInEachMachine) {
  constexpr std::string_view kScript = R"lua(
    local weak = setmetatable({}, {__mode = "v"})
    local kept, seen = {}, {}
    for i = 1, 30000 do
      local text = "text " .. i * 7919 % 10007 .. string.rep("x", i % 40)
      weak[#weak + 1] = {text}
      if i % 97 == 0 then kept[#kept + 1] = {text, {i}} end
      if i % 1000 == 0 then
        local alive = 0
        for _ in pairs(weak) do alive = alive + 1 end
        seen[#seen + 1] = alive
      end
    end
    local set, order = {}, {}
    for _, entry in ipairs(kept) do set[entry] = entry[2][1] end
    for i = 1, 300 do set[{}] = i end
    for _, value in pairs(set) do order[#order + 1] = value end
    print(table.concat(seen, " "), table.concat(order, " ")))lua";
  std::string first;
  std::size_t first_bytes = 0;
  for (int machine = 0; machine < 8; ++machine) {
    Start({});
    const std::string printed = Run(kScript);
    if (machine == 0) {
      first = printed;
      first_bytes = machine_->memory().used_bytes();
      EXPECT_EQ(printed.rfind("error", 0), std::string::npos) << printed;
      EXPECT_LT(first_bytes, std::size_t{4} << 20) << "nothing was collected";
    }
    EXPECT_EQ(printed, first);
    EXPECT_EQ(machine_->memory().used_bytes(), first_bytes);
  }
}

TEST_F(MachineTest, GarbageDoesNotMakeAScriptReachItsLimit) {
  MachineLimits limits;
  limits.memory_bytes = std::size_t{4} << 20;
  Start(limits);
  // Two megabytes are kept, and a hundred are freed.
  EXPECT_EQ(Run(R"lua(
    local kept, length = {}, 0
    for i = 1, 2000 do kept[i] = string.rep("k", 1000) .. i end
    for i = 1, 100000 do length = length + #(string.rep("g", 1000) .. i) end
    print(#kept, length > 1e8))lua"),
            "2000\ttrue");
}

}  // namespace
}  // namespace soarbox::script
