// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include "call.h"

/// Python functions as handlers of the library, and calls of the library from Python.
namespace soarbox::python {

/// An exception is set in Python.
class PythonError : public std::exception {};

/// Calls the library without the interpreter's lock if a kernel is concerned: other threads of Python go on, and
/// handlers can take the lock. Throws PythonError if a handler was interrupted (Ctrl+C, sys.exit).
void CallLibrary(bindings::Call::Hold hold, const std::function<void()>& call);
/// The same for calls that have no object yet: those that make kernels.
void CallFactory(const std::function<void()>& call);
/// Sets the exception in Python for the one that is being handled in C++.
void RaiseInPython();

/// New references to objects of Python for what a handler is given; defined beside SWIG's tables.
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

/// Forgets what was registered under an id, after the library has.
using bindings::Forget;

/// Stops all runs, shuts the kernels down, and lets no handler into Python any more: the interpreter is about to end.
void End();

}  // namespace soarbox::python
