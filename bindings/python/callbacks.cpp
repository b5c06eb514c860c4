// SPDX-License-Identifier: BSD-2-Clause
#include "callbacks.h"

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <thread>

namespace soarbox::python {

using bindings::KernelEntry;

namespace {

/// Counts the handlers that are running in Python (`inside`). No handler may start after `shut` is set.
struct Door {
  std::mutex mutex;
  std::condition_variable left;
  int inside = 0;
  bool shut = false;

  bool Enter() {
    const std::lock_guard lock(mutex);
    if (shut) return false;
    ++inside;
    return true;
  }
  void Leave() {
    const std::lock_guard lock(mutex);
    --inside;
    left.notify_all();
  }
};

Door& TheDoor() {
  static auto* door = new Door;
  return *door;
}

/// The exception that interrupted a handler of this thread. Kept until the call that the handler ran in has ended.
struct Interruption {
  PyObject *type = nullptr, *value = nullptr, *traceback = nullptr;
};
thread_local Interruption interruption;

/// A Python function, its data, and its description for messages (`what`).
struct Callback : std::enable_shared_from_this<Callback> {
  Callback(PyObject* function, PyObject* data, const char* what, std::shared_ptr<KernelEntry> entry)
      : function(function), data(data), what(what), entry(std::move(entry)) {
    const PyGILState_STATE state = PyGILState_Ensure();
    Py_INCREF(function);
    Py_INCREF(data);
    PyGILState_Release(state);
  }
  ~Callback() {
    if (!TheDoor().Enter()) return;
    const PyGILState_STATE state = PyGILState_Ensure();
    Py_DECREF(function);
    Py_DECREF(data);
    PyGILState_Release(state);
    TheDoor().Leave();
  }
  Callback(const Callback&) = delete;
  Callback& operator=(const Callback&) = delete;

  PyObject* const function;
  PyObject* const data;
  const char* const what;
  const std::weak_ptr<KernelEntry> entry;
};

PyObject* Text(const char* text) {
  if (!text) Py_RETURN_NONE;
  return PyUnicode_DecodeUTF8(text, static_cast<Py_ssize_t>(std::strlen(text)), "surrogateescape");
}

/// The result of a function that rules call: a text, or the str() of any other value; nothing for None.
std::string AnswerText(PyObject* answer) {
  if (answer == Py_None) return {};
  PyObject* text = PyObject_Str(answer);
  PyObject* bytes = text ? PyUnicode_AsEncodedString(text, "utf-8", "surrogateescape") : nullptr;
  std::string result;
  if (bytes) result = PyBytes_AsString(bytes);
  Py_XDECREF(bytes);
  Py_XDECREF(text);
  return result;
}

/// Prints the exception of a handler. An exception that ends the program stops the agents instead, and the call in
/// which they ran raises it again.
void HandleException(const Callback& callback, KernelEntry& entry) {
  const bool ends = PyErr_ExceptionMatches(PyExc_KeyboardInterrupt) || PyErr_ExceptionMatches(PyExc_SystemExit);
  if (ends && bindings::Call::IsInside()) {
    Py_XDECREF(interruption.type);
    Py_XDECREF(interruption.value);
    Py_XDECREF(interruption.traceback);
    PyErr_Fetch(&interruption.type, &interruption.value, &interruption.traceback);
    entry.kernel()->StopAllAgents();
    return;
  }
  PySys_WriteStderr("Exception in the handler of %s:\n", callback.what);
  // Not PyErr_Print, which ends the program for SystemExit.
  PyObject *type = nullptr, *value = nullptr, *traceback = nullptr;
  PyErr_Fetch(&type, &value, &traceback);
  PyErr_NormalizeException(&type, &value, &traceback);
  PyErr_Display(type, value, traceback);
  Py_XDECREF(type);
  Py_XDECREF(value);
  Py_XDECREF(traceback);
}

/// Calls the Python function. `arguments` returns the tuple of arguments, or null and sets an exception.
template <typename Arguments>
std::string Run(void* data, Arguments arguments) {
  const std::shared_ptr<KernelEntry> entry = static_cast<Callback*>(data)->entry.lock();
  if (!entry || !entry->Enter()) return {};
  std::string result;
  if (TheDoor().Enter()) {
    const PyGILState_STATE state = PyGILState_Ensure();
    {
      // It may be dropped while it runs.
      const std::shared_ptr<Callback> callback = static_cast<Callback*>(data)->shared_from_this();
      PyObject* tuple = arguments(callback->data);
      PyObject* answer = tuple ? PyObject_CallObject(callback->function, tuple) : nullptr;
      if (answer) result = AnswerText(answer);
      if (PyErr_Occurred()) HandleException(*callback, *entry);
      Py_XDECREF(answer);
      Py_XDECREF(tuple);
    }
    PyGILState_Release(state);
    TheDoor().Leave();
  }
  entry->Leave(false);
  return result;
}

void RunRun(sml::smlRunEventId id, void* data, sml::Agent* agent, sml::smlPhase phase) {
  Run(data, [&](PyObject* own) { return Py_BuildValue("(iONi)", id, own, NewAgent(agent), phase); });
}
void RunProduction(sml::smlProductionEventId id, void* data, sml::Agent* agent, const char* rule,
                   const char* instantiation) {
  Run(data, [&](PyObject* own) {
    return Py_BuildValue("(iONNN)", id, own, NewAgent(agent), Text(rule), Text(instantiation));
  });
}
void RunPrint(sml::smlPrintEventId id, void* data, sml::Agent* agent, const char* message) {
  Run(data, [&](PyObject* own) { return Py_BuildValue("(iONN)", id, own, NewAgent(agent), Text(message)); });
}
void RunXml(sml::smlXMLEventId id, void* data, sml::Agent* agent, sml::ClientXML* xml) {
  Run(data, [&](PyObject* own) { return Py_BuildValue("(iONN)", id, own, NewAgent(agent), NewXml(xml)); });
}
void RunOutput(void* data, sml::Agent* agent, const char* command, sml::WMElement* element) {
  Run(data,
      [&](PyObject* own) { return Py_BuildValue("(ONNN)", own, NewAgent(agent), Text(command), NewElement(element)); });
}
void RunOutputNotification(void* data, sml::Agent* agent) {
  Run(data, [&](PyObject* own) { return Py_BuildValue("(ON)", own, NewAgent(agent)); });
}
void RunSystem(sml::smlSystemEventId id, void* data, sml::Kernel* kernel) {
  Run(data, [&](PyObject* own) { return Py_BuildValue("(iON)", id, own, NewKernel(kernel)); });
}
void RunUpdate(sml::smlUpdateEventId id, void* data, sml::Kernel* kernel, sml::smlRunFlags flags) {
  Run(data, [&](PyObject* own) { return Py_BuildValue("(iONi)", id, own, NewKernel(kernel), flags); });
}
std::string RunString(sml::smlStringEventId id, void* data, sml::Kernel* kernel, const char* text) {
  return Run(data, [&](PyObject* own) { return Py_BuildValue("(iONN)", id, own, NewKernel(kernel), Text(text)); });
}
void RunAgent(sml::smlAgentEventId id, void* data, sml::Agent* agent) {
  Run(data, [&](PyObject* own) { return Py_BuildValue("(iON)", id, own, NewAgent(agent)); });
}
std::string RunFunction(sml::smlRhsEventId id, void* data, sml::Agent* agent, const char* name, const char* argument) {
  return Run(data, [&](PyObject* own) {
    return Py_BuildValue("(iONNN)", id, own, NewAgent(agent), Text(name), Text(argument));
  });
}

/// Creates a callback, passes it to `registers`, and stores it if the result is an id (not 0).
template <typename Registers>
int Register(sml::Kernel* kernel, unsigned long long agent_life, const char* what, PyObject* function, PyObject* data,
             Registers registers) {
  const PyGILState_STATE state = PyGILState_Ensure();
  const bool callable = PyCallable_Check(function) != 0;
  if (!callable) PyErr_Format(PyExc_TypeError, "the handler of %s must be callable, not %R", what, function);
  if (!callable && bindings::Call::IsInside()) {
    PyErr_Fetch(&interruption.type, &interruption.value, &interruption.traceback);
  }
  PyGILState_Release(state);
  if (!callable) return 0;
  const std::shared_ptr<KernelEntry> entry = KernelEntry::Of(kernel);
  return bindings::Register(entry, agent_life, std::make_shared<Callback>(function, data, what, entry), registers);
}

/// Lets Ctrl+C reach Python during a run: checks for signals periodically, on the thread on which Python handles them.
void LookForSignals(sml::smlSystemEventId, void*, sml::Kernel* kernel) {
  static thread_local std::chrono::steady_clock::time_point last;
  const auto now = std::chrono::steady_clock::now();
  if (now - last < std::chrono::milliseconds(50)) return;
  last = now;
  if (!bindings::Call::IsInside() || !TheDoor().Enter()) return;
  const PyGILState_STATE state = PyGILState_Ensure();
  if (PyErr_CheckSignals() != 0) {
    PyErr_Fetch(&interruption.type, &interruption.value, &interruption.traceback);
    kernel->StopAllAgents();
  }
  PyGILState_Release(state);
  TheDoor().Leave();
}

/// Sets the exception that interrupted a handler, if there is one.
bool RaiseInterruption() {
  if (!interruption.type) return false;
  PyErr_Restore(interruption.type, interruption.value, interruption.traceback);
  interruption = {};
  return true;
}

}  // namespace

void CallLibrary(bindings::Call::Hold hold, const std::function<void()>& function) {
  bindings::Call call;
  if (!call.entry()) {
    function();
    return;
  }
  std::exception_ptr failure;
  PyThreadState* thread = PyEval_SaveThread();
  try {
    call.Now(hold, function);
  } catch (const std::exception&) {
    failure = std::current_exception();
  }
  // Not in a destructor: if the interpreter has ended, this call ends the thread.
  PyEval_RestoreThread(thread);
  if (call.outermost()) call.entry()->DropLeavers();
  if (RaiseInterruption()) throw PythonError();
  if (failure) std::rethrow_exception(failure);
}

void CallFactory(const std::function<void()>& function) {
  std::exception_ptr failure;
  PyThreadState* thread = PyEval_SaveThread();
  try {
    function();
    const std::optional<bindings::Life>& made = bindings::LastReturned().life;
    sml::Kernel* kernel = made ? made->entry->kernel() : nullptr;
    if (kernel && !kernel->IsRemoteConnection()) {
      kernel->RegisterForSystemEvent(sml::smlEVENT_INTERRUPT_CHECK, LookForSignals, nullptr);
    }
  } catch (const std::exception&) {
    failure = std::current_exception();
  }
  PyEval_RestoreThread(thread);
  if (failure) std::rethrow_exception(failure);
}

void RaiseInPython() {
  try {
    throw;
  } catch (const PythonError&) {
    // The exception is already set.
  } catch (const bindings::Gone& gone) {
    PyErr_SetString(PyExc_ReferenceError, gone.what());
  } catch (const std::invalid_argument& wrong) {
    PyErr_SetString(PyExc_ValueError, wrong.what());
  } catch (const std::bad_alloc&) {
    PyErr_NoMemory();
  } catch (const std::exception& failure) {
    PyErr_SetString(PyExc_RuntimeError, failure.what());
  }
}

int OnRun(sml::Agent& agent, int event, PyObject* function, PyObject* data, bool to_back) {
  return Register(
      agent.GetKernel(), agent.GetLife(), "a run event", function, data,
      [&, id = bindings::RunEvent(event)](void* own) { return agent.RegisterForRunEvent(id, RunRun, own, to_back); });
}
int OnProduction(sml::Agent& agent, int event, PyObject* function, PyObject* data, bool to_back) {
  return Register(agent.GetKernel(), agent.GetLife(), "a production event", function, data,
                  [&, id = bindings::ProductionEvent(event)](void* own) {
                    return agent.RegisterForProductionEvent(id, RunProduction, own, to_back);
                  });
}
int OnPrint(sml::Agent& agent, int event, PyObject* function, PyObject* data, bool ignore_own_echos, bool to_back) {
  return Register(agent.GetKernel(), agent.GetLife(), "a print event", function, data,
                  [&, id = bindings::PrintEvent(event)](void* own) {
                    return agent.RegisterForPrintEvent(id, RunPrint, own, ignore_own_echos, to_back);
                  });
}
int OnXml(sml::Agent& agent, int event, PyObject* function, PyObject* data, bool to_back) {
  return Register(
      agent.GetKernel(), agent.GetLife(), "an XML event", function, data,
      [&, id = bindings::XmlEvent(event)](void* own) { return agent.RegisterForXMLEvent(id, RunXml, own, to_back); });
}
int OnOutput(sml::Agent& agent, const char* attribute, PyObject* function, PyObject* data, bool to_back) {
  return Register(agent.GetKernel(), agent.GetLife(), "output", function, data,
                  [&](void* own) { return agent.AddOutputHandler(attribute, RunOutput, own, to_back); });
}
int OnOutputNotification(sml::Agent& agent, PyObject* function, PyObject* data, bool to_back) {
  return Register(agent.GetKernel(), agent.GetLife(), "an output notification", function, data,
                  [&](void* own) { return agent.RegisterForOutputNotification(RunOutputNotification, own, to_back); });
}
int OnSystem(sml::Kernel& kernel, int event, PyObject* function, PyObject* data, bool to_back) {
  return Register(&kernel, 0, "a system event", function, data, [&, id = bindings::SystemEvent(event)](void* own) {
    return kernel.RegisterForSystemEvent(id, RunSystem, own, to_back);
  });
}
int OnUpdate(sml::Kernel& kernel, int event, PyObject* function, PyObject* data, bool to_back) {
  return Register(&kernel, 0, "an update event", function, data, [&, id = bindings::UpdateEvent(event)](void* own) {
    return kernel.RegisterForUpdateEvent(id, RunUpdate, own, to_back);
  });
}
int OnString(sml::Kernel& kernel, int event, PyObject* function, PyObject* data, bool to_back) {
  return Register(&kernel, 0, "a string event", function, data, [&, id = bindings::StringEvent(event)](void* own) {
    return kernel.RegisterForStringEvent(id, RunString, own, to_back);
  });
}
int OnAgent(sml::Kernel& kernel, int event, PyObject* function, PyObject* data, bool to_back) {
  return Register(&kernel, 0, "an agent event", function, data, [&, id = bindings::AgentEvent(event)](void* own) {
    return kernel.RegisterForAgentEvent(id, RunAgent, own, to_back);
  });
}
int AddRhsFunction(sml::Kernel& kernel, const char* name, PyObject* function, PyObject* data, bool to_back) {
  return Register(&kernel, 0, "a right-hand-side function", function, data,
                  [&](void* own) { return kernel.AddRhsFunction(name, RunFunction, own, to_back); });
}
int OnClientMessage(sml::Kernel& kernel, const char* client, PyObject* function, PyObject* data, bool to_back) {
  return Register(&kernel, 0, "a client message", function, data,
                  [&](void* own) { return kernel.RegisterForClientMessageEvent(client, RunFunction, own, to_back); });
}

void End() {
  PyThreadState* thread = PyEval_SaveThread();
  bindings::EndKernels();
  {
    Door& door = TheDoor();
    std::unique_lock lock(door.mutex);
    door.shut = true;
    // Does not wait for a handler that never returns.
    door.left.wait_for(lock, std::chrono::seconds(2), [&] { return door.inside == 0; });
  }
  PyEval_RestoreThread(thread);
}

}  // namespace soarbox::python
