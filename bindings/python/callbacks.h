// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include "call.h"

/// Registers Python functions as handlers of the library, and calls the library from Python.
namespace soarbox::python {

/// Thrown when an exception is set in Python.
class PythonError : public std::exception {};

/// Calls the library. If the call belongs to a kernel, it releases the interpreter's lock, so that other Python threads
/// continue and handlers can take the lock. Throws PythonError if a handler was interrupted (Ctrl+C, sys.exit).
void CallLibrary(bindings::Call::Hold hold, const std::function<void()>& call);
/// The same for calls that create kernels, which have no object yet.
void CallFactory(const std::function<void()>& call);
/// Sets an exception in Python for the C++ exception that is being handled.
void RaiseInPython();

/// Return new references to Python objects for the arguments of a handler. Defined next to SWIG's tables.
PyObject* NewKernel(sml::Kernel* kernel);
PyObject* NewAgent(sml::Agent* agent);
PyObject* NewElement(sml::WMElement* element);
PyObject* NewElement(sml::WMElement* element, bindings::Life life);
PyObject* NewXml(sml::ClientXML* xml);

/// Register a Python function. They return the id; 0 if the library refuses. They throw std::invalid_argument if the
/// event is none of this kind, PythonError if the function cannot be called.
int OnRun(sml::Agent& agent, int event, PyObject* function, PyObject* data, bool to_back);
int OnProduction(sml::Agent& agent, int event, PyObject* function, PyObject* data, bool to_back);
int OnPrint(sml::Agent& agent, int event, PyObject* function, PyObject* data, bool ignore_own_echos, bool to_back);
int OnXml(sml::Agent& agent, int event, PyObject* function, PyObject* data, bool to_back);
int OnOutput(sml::Agent& agent, const char* attribute, PyObject* function, PyObject* data, bool to_back);
int OnOutputNotification(sml::Agent& agent, PyObject* function, PyObject* data, bool to_back);
int OnSystem(sml::Kernel& kernel, int event, PyObject* function, PyObject* data, bool to_back);
int OnUpdate(sml::Kernel& kernel, int event, PyObject* function, PyObject* data, bool to_back);
int OnString(sml::Kernel& kernel, int event, PyObject* function, PyObject* data, bool to_back);
int OnAgent(sml::Kernel& kernel, int event, PyObject* function, PyObject* data, bool to_back);
int AddRhsFunction(sml::Kernel& kernel, const char* name, PyObject* function, PyObject* data, bool to_back);
int OnClientMessage(sml::Kernel& kernel, const char* client, PyObject* function, PyObject* data, bool to_back);

/// Drops the handler with this id, after the library has removed it.
using bindings::Forget;

/// Stops all runs, shuts the kernels down, and prevents further calls of handlers, because the interpreter is about to
/// end.
void End();

}  // namespace soarbox::python
