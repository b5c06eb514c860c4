# SPDX-License-Identifier: BSD-2-Clause
"""The client interface of Soar in Python: names, handlers, both kinds of kernels, and mistakes of programs."""
import contextlib
import gc
import io
import itertools
import signal
import subprocess
import sys
import tempfile
import threading
import unittest
import weakref

import Python_sml_ClientInterface as sml
import soar_sml

COUNTER = """
sp {propose*count (state <s> ^superstate nil -^stop) --> (<s> ^operator <o> + =) (<o> ^name count)}
sp {apply*count (state <s> ^operator.name count ^io.output-link <out>) --> (<out> ^count <c>) (<c> ^by 1)}
"""


class WithKernel(unittest.TestCase):
    def setUp(self):
        self.kernel = sml.Kernel.CreateKernelInNewThread(sml.Kernel.kUseAnyPort)
        self.assertFalse(self.kernel.HadError(), self.kernel.GetLastErrorDescription())
        self.agent = self.kernel.CreateAgent("scout")

    def tearDown(self):
        self.kernel.Shutdown()

    def load(self, rules, agent=None):
        with tempfile.NamedTemporaryFile("w", suffix=".soar") as file:
            file.write(rules)
            file.flush()
            self.assertTrue((agent or self.agent).LoadProductions(file.name))


class Names(WithKernel):
    def test_both_modules_have_the_same_objects(self):
        self.assertIs(soar_sml.Kernel, sml.Kernel)
        self.assertIs(soar_sml.Agent, sml.Agent)

    def test_constants_have_their_numbers(self):
        self.assertEqual(sml.Kernel.kDefaultSMLPort, 12121)
        self.assertEqual((sml.smlEVENT_AFTER_RUNNING, sml.smlEVENT_PRINT, sml.smlEVENT_CLIENT_MESSAGE), (36, 47, 50))
        self.assertEqual((sml.sml_PHASE, sml.sml_DECIDE, sml.sml_UNTIL_OUTPUT), (0, 2, 3))
        self.assertEqual(sml.sml_Names.kSoarVersionValue, "9.6.3")

    def test_static_functions_have_their_flat_names_too(self):
        kernel = sml.Kernel_CreateKernelInCurrentThread(True, 0)
        self.assertEqual(kernel.CreateAgent("a").GetAgentName(), "a")

    def test_nothing_is_made_without_a_kernel(self):
        for made in (sml.Kernel, sml.Agent, sml.Identifier):
            with self.assertRaises(AttributeError):
                made()


class Elements(WithKernel):
    def test_input_is_made_changed_and_removed(self):
        link = self.agent.GetInputLink()
        place = link.CreateIdWME("place")
        x = place.CreateIntWME("x", 3)
        y = self.agent.CreateFloatWME(place, "y", 2.5)
        name = place.CreateStringWME("name", "gate")
        self.agent.RunSelf(1)
        self.assertIn("^x 3 ^y 2.5", self.agent.ExecuteCommandLine("print p1").replace("\n", " "))
        x.Update(4)
        self.agent.Update(y, 0.5)
        self.assertTrue(name.DestroyWME())
        self.agent.RunSelf(1)
        self.assertEqual((x.GetValue(), y.GetValue()), (4, 0.5))
        self.assertNotIn("gate", self.agent.ExecuteCommandLine("print p1"))

    def test_children_have_the_type_of_their_value(self):
        link = self.agent.GetInputLink()
        link.CreateIdWME("a")
        link.CreateIntWME("b", 1)
        link.CreateFloatWME("c", 1)
        link.CreateStringWME("d", "e")
        kinds = [type(link.GetChild(i)) for i in range(link.GetNumberChildren())]
        self.assertEqual(kinds, [sml.Identifier, sml.IntElement, sml.FloatElement, sml.StringElement])
        self.assertIsNone(link.GetChild(4))
        self.assertIsNone(link.FindByAttribute("z", 0))
        self.assertEqual(link.FindByAttribute("b", 0).ConvertToIntElement().GetValue(), 1)
        self.assertEqual(link.GetParameterValue("d"), "e")

    def test_text_of_any_language_returns_unchanged(self):
        for text in ("Grüße", "水", "a b", ""):
            element = self.agent.GetInputLink().CreateStringWME("text", text)
            self.assertEqual(element.GetValue(), text)

    def test_commands_are_read_and_answered(self):
        self.load(COUNTER)
        self.agent.RunSelfTilOutput()
        self.assertTrue(self.agent.Commands())
        self.assertEqual(self.agent.GetNumberCommands(), 1)
        command = self.agent.GetCommand(0)
        self.assertEqual((command.GetCommandName(), command.GetParameterValue("by")), ("count", "1"))
        command.AddStatusComplete()
        self.agent.RunSelf(1)
        self.assertEqual(command.GetParameterValue("status"), "complete")

    def test_structured_answers_are_objects_of_their_own(self):
        answer = sml.ClientAnalyzedXML()
        self.assertTrue(self.agent.ExecuteCommandLineXML("stats", answer))
        result = answer.GetResultTag()
        del answer
        gc.collect()
        self.assertTrue(result.IsTag("result"))
        self.assertIn("<result", result.GenerateXMLString(True))
        self.assertIsNone(sml.ElementXML.ParseXMLFromString("<a"))


class Handlers(WithKernel):
    def test_every_family_calls_with_its_arguments(self):
        seen = {}

        def note(name):
            def handler(*arguments):
                seen.setdefault(name, []).append(arguments)
                return "an answer"
            return handler

        agent, kernel, data = self.agent, self.kernel, {"any": "object"}
        agent.RegisterForRunEvent(sml.smlEVENT_AFTER_DECISION_CYCLE, note("run"), data)
        agent.RegisterForProductionEvent(sml.smlEVENT_AFTER_PRODUCTION_FIRED, note("production"), data)
        agent.RegisterForPrintEvent(sml.smlEVENT_PRINT, note("print"), data)
        agent.RegisterForXMLEvent(sml.smlEVENT_XML_TRACE_OUTPUT, note("xml"), data)
        agent.RegisterForOutputNotification(note("notification"), data)
        agent.AddOutputHandler("count", note("output"), data)
        kernel.RegisterForSystemEvent(sml.smlEVENT_SYSTEM_START, note("system"), data)
        kernel.RegisterForUpdateEvent(sml.smlEVENT_AFTER_ALL_OUTPUT_PHASES, note("update"), data)
        kernel.RegisterForAgentEvent(sml.smlEVENT_AFTER_AGENT_CREATED, note("agent"), data)
        kernel.RegisterForClientMessageEvent("me", note("message"), data)
        kernel.AddRhsFunction("ask", note("function"), data)
        self.load(COUNTER + "sp {ask (state <s> ^superstate nil) --> (<s> ^answer (exec ask |a b| 3))}")
        kernel.RunAllAgents(2)
        kernel.CreateAgent("second")
        self.assertEqual(kernel.SendClientMessage(agent, "me", "how are you?"), "an answer")

        families = "run production print xml notification output system update agent message function"
        self.assertEqual(set(seen), set(families.split()))
        own = {name: calls[0][0 if name in ("notification", "output") else 1] for name, calls in seen.items()}
        self.assertTrue(all(value is data for value in own.values()), own)
        event, _, who, phase = seen["run"][0]
        self.assertEqual((event, who.GetAgentName(), type(phase)), (sml.smlEVENT_AFTER_DECISION_CYCLE, "scout", int))
        self.assertIn("propose*count", [call[3] for call in seen["production"]])
        self.assertIsNone(seen["production"][0][4])
        self.assertTrue(all(isinstance(call[3], str) for call in seen["print"]))
        # A part of the trace outlives the handler.
        self.assertIn("<trace", seen["xml"][0][3].GenerateXMLString(True))
        self.assertEqual(seen["xml"][0][3].ConvertToTraceXML().GetTagName(), "trace")
        self.assertEqual(seen["output"][0][2], "count")
        self.assertIsInstance(seen["output"][0][3], sml.Identifier)
        self.assertEqual(seen["function"][0][3:], ("ask", "a b3"))
        self.assertEqual(seen["message"][0][3:], ("me", "how are you?"))
        self.assertIn("^answer |an answer|", agent.ExecuteCommandLine("print s1"))

    def test_functions_may_answer_with_numbers_and_with_nothing(self):
        answers = iter([3, None, 2.5])
        self.kernel.AddRhsFunction("next", lambda *arguments: next(answers))
        self.load("sp {a (state <s> ^superstate nil) --> (<s> ^v (exec next))}")
        self.agent.RunSelf(1)
        self.assertIn("^v |3|", self.agent.ExecuteCommandLine("print s1"))

    def test_an_unregistered_handler_is_let_go(self):
        class Data:
            pass
        calls = []
        data = Data()
        alive = weakref.ref(data)
        number = self.agent.RegisterForRunEvent(sml.smlEVENT_BEFORE_INPUT_PHASE, lambda *a: calls.append(1), data)
        self.assertGreater(number, 0)
        del data
        gc.collect()
        self.assertIsNotNone(alive())
        self.assertTrue(self.agent.UnregisterForRunEvent(number))
        self.assertFalse(self.agent.UnregisterForRunEvent(number))
        self.agent.RunSelf(1)
        self.assertEqual(calls, [])
        gc.collect()
        self.assertIsNone(alive())

    def test_handlers_of_a_destroyed_agent_are_let_go(self):
        class Data:
            pass
        data = Data()
        alive = weakref.ref(data)
        self.agent.RegisterForRunEvent(sml.smlEVENT_BEFORE_INPUT_PHASE, print, data)
        del data
        self.kernel.DestroyAgent(self.agent)
        gc.collect()
        self.assertIsNone(alive())

    def test_a_handler_may_unregister_itself(self):
        calls = []

        def once(*arguments):
            calls.append(arguments)
            self.agent.UnregisterForRunEvent(number)

        number = self.agent.RegisterForRunEvent(sml.smlEVENT_BEFORE_INPUT_PHASE, once)
        self.agent.RunSelf(3)
        self.assertEqual(len(calls), 1)

    def test_an_exception_is_printed_and_the_run_goes_on(self):
        def fails(*arguments):
            raise KeyError("the shelf is empty")

        self.agent.RegisterForRunEvent(sml.smlEVENT_BEFORE_INPUT_PHASE, fails)
        errors = io.StringIO()
        with contextlib.redirect_stderr(errors):
            self.agent.RunSelf(2)
        self.assertEqual(errors.getvalue().count("KeyError: 'the shelf is empty'"), 2)
        self.assertIn("Exception in the handler of a run event", errors.getvalue())
        self.assertEqual(self.agent.GetDecisionCycleCounter(), 2)

    def test_leaving_from_a_handler_ends_the_run_that_it_is_in(self):
        self.agent.RegisterForRunEvent(sml.smlEVENT_BEFORE_INPUT_PHASE, lambda *arguments: sys.exit(7))
        with self.assertRaises(SystemExit) as leaving:
            self.agent.RunSelfForever()
        self.assertEqual(leaving.exception.code, 7)

    def test_events_of_another_kind_and_handlers_that_are_none_are_refused(self):
        with self.assertRaisesRegex(ValueError, "47 is not a number of a run event"):
            self.agent.RegisterForRunEvent(sml.smlEVENT_PRINT, print)
        with self.assertRaisesRegex(TypeError, "must be callable, not 'text'"):
            self.agent.RegisterForPrintEvent(sml.smlEVENT_PRINT, "text")


class OtherThreads(WithKernel):
    def test_python_goes_on_while_agents_run_and_can_stop_them(self):
        self.load(COUNTER)
        reached = threading.Event()

        def handler(*arguments):
            if self.agent.GetDecisionCycleCounter() >= 20:
                reached.set()

        self.agent.RegisterForRunEvent(sml.smlEVENT_AFTER_DECISION_CYCLE, handler)
        thread = threading.Thread(target=self.agent.RunSelfForever)
        thread.start()
        reached.wait()
        self.agent.StopSelf()
        thread.join()
        self.assertGreaterEqual(self.agent.GetDecisionCycleCounter(), 20)

    def test_many_threads_may_use_one_kernel(self):
        wrong = []

        def work(number):
            for i in range(50):
                answer = self.agent.ExecuteCommandLine(f"echo {number}-{i}")
                if answer.strip() != f"{number}-{i}":
                    wrong.append(answer)

        threads = [threading.Thread(target=work, args=(number,)) for number in range(4)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(wrong, [])


class Remote(WithKernel):
    def setUp(self):
        super().setUp()
        self.remote = sml.Kernel.CreateRemoteConnection(True, None, self.kernel.GetListenerPort())
        self.assertFalse(self.remote.HadError(), self.remote.GetLastErrorDescription())

    def tearDown(self):
        self.remote.Shutdown()
        super().tearDown()

    def test_a_remote_client_gives_input_and_takes_commands(self):
        agent = self.remote.GetAgent("scout")
        self.load(COUNTER, agent)
        commands = []
        agent.AddOutputHandler("count", lambda data, who, name, command: commands.append(command.GetParameterValue("by")))
        agent.GetInputLink().CreateIntWME("n", 5)
        agent.RunSelf(3)
        self.assertEqual(commands, ["1"])
        self.assertIn("^n 5", self.agent.ExecuteCommandLine("print i2"))

    def test_rules_call_functions_of_a_remote_client(self):
        self.remote.AddRhsFunction("add", lambda event, data, who, name, argument: str(int(argument) + data), 40)
        self.load("sp {a (state <s> ^superstate nil) --> (<s> ^v (exec add 2))}")
        self.remote.RunAllAgents(1)
        self.assertIn("^v |42|", self.agent.ExecuteCommandLine("print s1"))

    def test_nobody_there_is_an_error_and_no_crash(self):
        nobody = sml.Kernel.CreateRemoteConnection(True, None, 1)
        self.assertTrue(nobody.HadError())
        self.assertIsNone(nobody.GetAgent("scout"))
        self.assertIsNone(nobody.CreateAgent("scout"))


class Gone(WithKernel):
    def test_a_destroyed_agent_and_its_elements_raise(self):
        link = self.agent.GetInputLink()
        number = link.CreateIntWME("n", 1)
        symbol = link.GetSymbol()
        self.assertTrue(self.kernel.IsAgentValid(self.agent))
        self.kernel.DestroyAgent(self.agent)
        self.assertFalse(self.kernel.IsAgentValid(self.agent))
        for call in (self.agent.GetAgentName, self.agent.StopSelf, self.agent.RunSelfForever, link.GetAttribute,
                     number.GetValue, lambda: number.Update(2), number.DestroyWME, symbol.GetIdentifierSymbol,
                     lambda: self.kernel.DestroyAgent(self.agent)):
            with self.assertRaises(ReferenceError):
                call()

    def test_another_agent_in_its_place_does_not_revive_it(self):
        held = []
        for _ in range(200):
            agent = self.kernel.CreateAgent("again")
            held.append((agent, agent.GetInputLink().CreateIntWME("n", 1)))
            self.kernel.DestroyAgent(agent)
        agent = self.kernel.CreateAgent("again")
        agent.GetInputLink().CreateIntWME("n", 1)
        for old, element in held:
            with self.assertRaises(ReferenceError):
                old.GetAgentName()
            with self.assertRaises(ReferenceError):
                element.GetValue()

    def test_another_element_in_its_place_does_not_revive_it(self):
        link = self.agent.GetInputLink()
        held = []
        for i in range(200):
            held.append(link.CreateIntWME("n", i))
            held[-1].DestroyWME()
        kept = link.CreateIntWME("n", -1)
        for element in held:
            with self.assertRaises(ReferenceError):
                element.Update(5)
        self.assertEqual(kept.GetValue(), -1)

    def test_output_that_the_agent_removed_raises(self):
        self.load("sp {a (state <s> ^io <io>) (<io> ^input-link.on yes ^output-link <out>) --> (<out> ^go <g>) (<g> ^x 1)}")
        on = self.agent.GetInputLink().CreateStringWME("on", "yes")
        self.agent.RunSelfTilOutput()
        command = self.agent.GetCommand(0)
        x = command.GetChild(0)
        self.assertEqual(x.GetAttribute(), "x")
        on.DestroyWME()
        self.agent.RunSelf(3)
        self.agent.ClearOutputLinkChanges()
        with self.assertRaises(ReferenceError):
            command.AddStatusComplete()
        with self.assertRaises(ReferenceError):
            x.GetValueAsString()

    def test_a_deleted_kernel_takes_all_with_it(self):
        kernel = sml.Kernel.CreateKernelInCurrentThread(True, sml.Kernel.kSuppressListener)
        agent = kernel.CreateAgent("a")
        link = agent.GetInputLink()
        seen = []
        kernel.RegisterForSystemEvent(sml.smlEVENT_BEFORE_SHUTDOWN, lambda event, data, k: seen.append(k))
        del kernel
        self.assertEqual(len(seen), 1)
        for call in (agent.GetAgentName, agent.GetKernel, link.GetAttribute, seen[0].GetNumberAgents):
            with self.assertRaises(ReferenceError):
                call()

    def test_a_kernel_may_be_let_go_inside_of_its_own_run(self):
        box = [sml.Kernel.CreateKernelInNewThread(sml.Kernel.kSuppressListener)]
        agent = box[0].CreateAgent("a")
        agent.RegisterForRunEvent(sml.smlEVENT_BEFORE_INPUT_PHASE, lambda *arguments: box.clear())
        agent.RunSelf(1000)
        with self.assertRaises(ReferenceError):
            agent.GetAgentName()

    def test_an_agent_may_be_destroyed_inside_of_a_handler(self):
        second = self.kernel.CreateAgent("second")

        def destroy(*arguments):
            if self.kernel.GetAgent("second"):
                self.kernel.DestroyAgent(second)

        self.agent.RegisterForRunEvent(sml.smlEVENT_BEFORE_INPUT_PHASE, destroy)
        self.agent.RunSelf(2)
        with self.assertRaises(ReferenceError):
            second.GetAgentName()

    def test_after_the_shutdown_calls_fail_in_words(self):
        self.kernel.Shutdown()
        self.assertIsNone(self.kernel.CreateAgent("late"))
        self.assertIn("shut down", self.kernel.GetLastErrorDescription())
        with self.assertRaises(ReferenceError):
            self.agent.RunSelf(1)


class WrongTypes(WithKernel):
    def test_every_method_survives_nonsense(self):
        link = self.agent.GetInputLink()
        xml, answer = sml.ClientXML(), sml.ClientAnalyzedXML()
        self.agent.ExecuteCommandLineXML("print s1", answer)
        objects = [self.kernel, self.agent, link, link.CreateIntWME("a", 1), link.CreateFloatWME("b", 1.0),
                   link.CreateStringWME("c", "d"), link.GetSymbol(), xml, answer, sml.ElementXML(),
                   xml.ConvertToTraceXML(), answer.GetCommandTag()]
        values = [None, 3, "s", 2.5, self.agent, link, self.kernel, b"x", [], -1, 2**70, lambda *arguments: None]
        left_out = {"Shutdown", "DestroyAgent", "RunSelfForever", "RunAllAgentsForever", "RunSelfTilOutput",
                    "RunAllTilOutput", "SpawnDebugger", "LoadExternalLibrary", "CreateKernelInNewThread",
                    "CreateKernelInCurrentThread", "CreateRemoteConnection", "SetTraceCommunications"}
        calls = 0
        for thing in objects:
            for name in dir(thing):
                method = getattr(thing, name)
                if name.startswith("_") or name in left_out or not callable(method):
                    continue
                for count in range(3):
                    for arguments in itertools.product(values, repeat=count):
                        calls += 1
                        # A file that cannot be written is an OSError.
                        with contextlib.suppress(TypeError, ValueError, OverflowError, ReferenceError, OSError):
                            method(*arguments)
        self.assertGreater(calls, 30000)
        self.assertEqual(self.agent.GetAgentName(), "scout")

    def test_wrong_types_are_named(self):
        with self.assertRaisesRegex(TypeError, "argument 2 of type 'long long'"):
            self.agent.GetInputLink().CreateIntWME("n", 1).Update("one")
        with self.assertRaisesRegex(TypeError, "must be a sml::Identifier"):
            self.agent.CreateIntWME("link", "n", 1)
        with self.assertRaisesRegex(TypeError, "the object is None"):
            sml.Agent.GetAgentName(None)

    def test_agents_of_another_kernel_are_refused(self):
        other = sml.Kernel.CreateKernelInNewThread(sml.Kernel.kSuppressListener)
        stranger = other.CreateAgent("scout")
        self.assertFalse(self.kernel.IsAgentValid(stranger))
        with self.assertRaisesRegex(ValueError, "another kernel"):
            self.kernel.DestroyAgent(stranger)
        self.assertEqual(stranger.GetAgentName(), "scout")


def program(text):
    return subprocess.Popen([sys.executable, "-c", "import soar_sml as sml\n" + text], stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True)


START = """
import sys, threading
kernel = sml.Kernel.CreateKernelInNewThread(sml.Kernel.kSuppressListener)
agent = kernel.CreateAgent("a")
def say(*arguments):
    if agent.GetDecisionCycleCounter() == 5: print("runs", flush=True)
agent.RegisterForRunEvent(sml.smlEVENT_AFTER_DECISION_CYCLE, say)
agent.ExecuteCommandLine("soar max-goal-depth 10000")
agent.ExecuteCommandLine("sp {p (state <s> ^superstate nil) --> (<s> ^operator <o> + =) (<o> ^name again)}")
agent.ExecuteCommandLine("sp {a (state <s> ^operator <o> ^a <a>) --> (<s> ^operator <o> - )}")
agent.ExecuteCommandLine("watch 0")
"""


class Endings(unittest.TestCase):
    def test_a_program_may_end_without_a_shutdown(self):
        child = program(START + "agent.RunSelf(10)\n")
        out, errors = child.communicate()
        self.assertEqual((child.returncode, out, errors), (0, "runs\n", ""))

    def test_a_program_may_end_while_another_thread_runs_agents(self):
        child = program(START + """
started = threading.Event()
agent.RegisterForRunEvent(sml.smlEVENT_BEFORE_INPUT_PHASE, lambda *arguments: started.set())
threading.Thread(target=agent.RunSelfForever, daemon=True).start()
started.wait()
""")
        _, errors = child.communicate()
        self.assertEqual((child.returncode, errors), (0, ""))

    def test_an_interrupt_ends_a_run(self):
        child = program(START + "agent.RunSelfForever()\n")
        self.assertEqual(child.stdout.readline(), "runs\n")
        child.send_signal(signal.SIGINT)
        _, errors = child.communicate()
        self.assertIn("KeyboardInterrupt", errors)
        self.assertNotEqual(child.returncode, 0)


if __name__ == "__main__":
    unittest.main()
