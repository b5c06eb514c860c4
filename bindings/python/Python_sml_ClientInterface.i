// SPDX-License-Identifier: BSD-2-Clause
%module Python_sml_ClientInterface
%feature("autodoc", "1");
%feature("compactdefaultargs");

%header %{
#include "callbacks.h"
%}

// Objects of the library are shared pointers. A call first checks that an object among its arguments still exists.
%define %soarbox_shared(TYPE...)
%feature("smartptr", noblock=1) TYPE { std::shared_ptr< TYPE > }
%feature("unref") TYPE %{ (void)arg1; delete smartarg1; %}
%typemap(in) TYPE * (void *argp = 0, int res = 0, int newmem = 0, std::shared_ptr< TYPE > cast, std::shared_ptr< TYPE > *smartarg = 0, soarbox::bindings::Argument argument) {
  res = SWIG_ConvertPtrAndOwn($input, &argp, $descriptor(std::shared_ptr< TYPE > *), $disown, &newmem);
  if (!SWIG_IsOK(res)) {
    SWIG_exception_fail(SWIG_ArgError(res), "in method '$symname', argument $argnum must be a $*1_ltype or None, not another type");
  }
  smartarg = reinterpret_cast< std::shared_ptr< TYPE > * >(argp);
  if (newmem & SWIG_CAST_NEW_MEMORY) {
    cast = *smartarg;
    delete smartarg;
    smartarg = &cast;
  }
  $1 = smartarg ? smartarg->get() : nullptr;
  if (smartarg) argument.Set(soarbox::bindings::LifeOf(*smartarg));
}
%typemap(typecheck, precedence=SWIG_TYPECHECK_POINTER, noblock=1) TYPE * {
  $1 = SWIG_CheckState(SWIG_ConvertPtr($input, 0, $descriptor(std::shared_ptr< TYPE > *), 0));
}
%typemap(out) TYPE * {
  $result = $1 ? SWIG_NewPointerObj(new std::shared_ptr< TYPE >(soarbox::bindings::Share($1, *soarbox::bindings::LastReturned().life)), $descriptor(std::shared_ptr< TYPE > *), SWIG_POINTER_OWN) : SWIG_Py_Void();
}
%typemap(doctype) TYPE * "TYPE"
%types(std::shared_ptr< TYPE > *);
%enddef

// The Python type of an element depends on its type in the library.
%define %soarbox_after_shared
%typemap(out) sml::WMElement * {
  $result = $1 ? soarbox::python::NewElement($1, *soarbox::bindings::LastReturned().life) : SWIG_Py_Void();
}
%enddef

// The object of a method is never None.
%typemap(check) SWIGTYPE *self {
  if (!$1) SWIG_exception_fail(SWIG_TypeError, "in method '$symname', the object is None");
}
%typemap(check) sml::ClientXML *pChild, soarxml::ElementXML *pChild, sml::ClientXML *pXML, sml::ClientAnalyzedXML *pResponse {
  if (!$1) SWIG_exception_fail(SWIG_TypeError, "in method '$symname', argument $argnum is None");
}

%typemap(out) sml::ConnectionInfo const * {
  $result = SWIG_NewPointerObj(const_cast<sml::ConnectionInfo *>($1), $descriptor(sml::ConnectionInfo *), SWIG_POINTER_OWN);
}

%define %soarbox_call(NAME, HOLD)
%exception NAME {
  try {
    soarbox::python::CallLibrary(soarbox::bindings::Call::Hold::HOLD, [&] {
      $action
      soarbox::bindings::TakeHome(result);
    });
  } catch (const std::exception&) {
    soarbox::python::RaiseInPython();
    SWIG_fail;
  }
}
%enddef

%define %soarbox_factory(NAME)
%exception sml::Kernel::NAME {
  try {
    soarbox::python::CallFactory([&] {
      $action
      soarbox::bindings::TakeHome(result);
    });
  } catch (const std::exception&) {
    soarbox::python::RaiseInPython();
    SWIG_fail;
  }
}
%typemap(out) sml::Kernel *NAME {
  $result = SWIG_NewPointerObj(new std::shared_ptr< sml::Kernel >($1, soarbox::bindings::Owned{*soarbox::bindings::LastReturned().life}), $descriptor(std::shared_ptr< sml::Kernel > *), SWIG_POINTER_OWN);
}
%enddef

%exception {
  try {
    soarbox::python::CallLibrary(soarbox::bindings::Call::Hold::kKernel, [&] {
      $action
      soarbox::bindings::TakeHome(result);
    });
  } catch (const std::exception&) {
    soarbox::python::RaiseInPython();
    SWIG_fail;
  }
}
%soarbox_call(sml::Agent::SoarboxStop, kNothing)
%soarbox_call(sml::Kernel::StopAllAgents, kNothing)
%soarbox_call(sml::Kernel::IsSoarRunning, kNothing)
%soarbox_call(sml::Kernel::IsConnectionClosed, kNothing)
%soarbox_call(sml::Kernel::IsRemoteConnection, kNothing)
%soarbox_call(sml::Kernel::IsDirectConnection, kNothing)
%soarbox_call(sml::Kernel::StartEventThread, kNothing)
%soarbox_call(sml::Kernel::StopEventThread, kNothing)
%soarbox_factory(CreateKernelInCurrentThread)
%soarbox_factory(CreateKernelInNewThread)
%soarbox_factory(CreateRemoteConnection)
// Handlers of a kernel that was shut down are released.
%exception sml::Kernel::Shutdown {
  try {
    soarbox::python::CallLibrary(soarbox::bindings::Call::Hold::kNothing, [&] {
      $action
      soarbox::bindings::Call::Near()->entry->DropAll();
    });
  } catch (const std::exception&) {
    soarbox::python::RaiseInPython();
    SWIG_fail;
  }
}
// An agent that no longer exists is not valid.
%exception sml::Kernel::IsAgentValid {
  try {
    soarbox::python::CallLibrary(soarbox::bindings::Call::Hold::kKernel, [&] { $action });
  } catch (const soarbox::bindings::Gone&) {
    result = false;
  } catch (const std::invalid_argument&) {
    result = false;
  } catch (const std::exception&) {
    soarbox::python::RaiseInPython();
    SWIG_fail;
  }
}
// Objects that no longer exist can be released.
%exception sml::ClientErrors::~ClientErrors { $action }
%exception sml::Agent::~Agent { $action }
%exception sml::WMElement::~WMElement { $action }
%exception sml::StringElement::~StringElement { $action }
%exception sml::IntElement::~IntElement { $action }
%exception sml::FloatElement::~FloatElement { $action }
%exception sml::Identifier::~Identifier { $action }
%exception sml::IdentifierSymbol::~IdentifierSymbol { $action }
// Releases the interpreter's lock, because handlers run while the kernel shuts down.
%exception sml::Kernel::~Kernel {
  PyThreadState *thread = PyEval_SaveThread();
  $action
  PyEval_RestoreThread(thread);
}

%extend sml::Agent {
  int RegisterForRunEvent(int id, PyObject *func, PyObject *userData = Py_None, bool addToBack = true) {
    return soarbox::python::OnRun(*$self, id, func, userData, addToBack);
  }
  int RegisterForProductionEvent(int id, PyObject *func, PyObject *userData = Py_None, bool addToBack = true) {
    return soarbox::python::OnProduction(*$self, id, func, userData, addToBack);
  }
  int RegisterForPrintEvent(int id, PyObject *func, PyObject *userData = Py_None, bool ignoreOwnEchos = true, bool addToBack = true) {
    return soarbox::python::OnPrint(*$self, id, func, userData, ignoreOwnEchos, addToBack);
  }
  int RegisterForXMLEvent(int id, PyObject *func, PyObject *userData = Py_None, bool addToBack = true) {
    return soarbox::python::OnXml(*$self, id, func, userData, addToBack);
  }
  int RegisterForOutputNotification(PyObject *func, PyObject *userData = Py_None, bool addToBack = true) {
    return soarbox::python::OnOutputNotification(*$self, func, userData, addToBack);
  }
  int AddOutputHandler(char const *pAttributeName, PyObject *func, PyObject *userData = Py_None, bool addToBack = true) {
    return soarbox::python::OnOutput(*$self, pAttributeName, func, userData, addToBack);
  }
}
%extend sml::Kernel {
  int RegisterForSystemEvent(int id, PyObject *func, PyObject *userData = Py_None, bool addToBack = true) {
    return soarbox::python::OnSystem(*$self, id, func, userData, addToBack);
  }
  int RegisterForUpdateEvent(int id, PyObject *func, PyObject *userData = Py_None, bool addToBack = true) {
    return soarbox::python::OnUpdate(*$self, id, func, userData, addToBack);
  }
  int RegisterForStringEvent(int id, PyObject *func, PyObject *userData = Py_None, bool addToBack = true) {
    return soarbox::python::OnString(*$self, id, func, userData, addToBack);
  }
  int RegisterForAgentEvent(int id, PyObject *func, PyObject *userData = Py_None, bool addToBack = true) {
    return soarbox::python::OnAgent(*$self, id, func, userData, addToBack);
  }
  int AddRhsFunction(char const *pRhsFunctionName, PyObject *func, PyObject *userData = Py_None, bool addToBack = true) {
    return soarbox::python::AddRhsFunction(*$self, pRhsFunctionName, func, userData, addToBack);
  }
  int RegisterForClientMessageEvent(char const *pClientName, PyObject *func, PyObject *userData = Py_None, bool addToBack = true) {
    return soarbox::python::OnClientMessage(*$self, pClientName, func, userData, addToBack);
  }
}

// The library removes a handler before the binding drops it.
%define %soarbox_forgets(CLASS, NAME)
%extend sml::CLASS {
  %rename(NAME) Soarbox##NAME;
  bool Soarbox##NAME(int callbackID) {
    if (!$self->NAME(callbackID)) return false;
    soarbox::python::Forget(*$self, callbackID);
    return true;
  }
}
%enddef

// All calls into the interpreter return before it ends.
%exception _End { $action }
%inline %{
void _End() { soarbox::python::End(); }
%}
%pythoncode %{
import atexit as _atexit
_atexit.register(_End)
%}

%include "../sml.i"

%header %{
namespace soarbox::python {

namespace {

template <typename T>
PyObject* NewShared(T* object, bindings::Life life, swig_type_info* type) {
  return SWIG_NewPointerObj(new std::shared_ptr<T>(bindings::Share(object, std::move(life))), type, SWIG_POINTER_OWN);
}

PyObject* NewNone() {
  Py_RETURN_NONE;
}

}  // namespace

PyObject* NewKernel(sml::Kernel* kernel) {
  if (!kernel) return NewNone();
  return NewShared(kernel, bindings::Life::Of(kernel), SWIGTYPE_p_std__shared_ptrT_sml__Kernel_t);
}

PyObject* NewAgent(sml::Agent* agent) {
  if (!agent) return NewNone();
  return NewShared(agent, bindings::Life::Of(agent), SWIGTYPE_p_std__shared_ptrT_sml__Agent_t);
}

PyObject* NewElement(sml::WMElement* element, bindings::Life life) {
  if (sml::Identifier* identifier = element->ConvertToIdentifier()) {
    return NewShared(identifier, std::move(life), SWIGTYPE_p_std__shared_ptrT_sml__Identifier_t);
  }
  if (sml::IntElement* number = element->ConvertToIntElement()) {
    return NewShared(number, std::move(life), SWIGTYPE_p_std__shared_ptrT_sml__IntElement_t);
  }
  if (sml::FloatElement* number = element->ConvertToFloatElement()) {
    return NewShared(number, std::move(life), SWIGTYPE_p_std__shared_ptrT_sml__FloatElement_t);
  }
  if (sml::StringElement* text = element->ConvertToStringElement()) {
    return NewShared(text, std::move(life), SWIGTYPE_p_std__shared_ptrT_sml__StringElement_t);
  }
  return NewShared(element, std::move(life), SWIGTYPE_p_std__shared_ptrT_sml__WMElement_t);
}

PyObject* NewElement(sml::WMElement* element) {
  return element ? NewElement(element, bindings::Life::Of(element)) : NewNone();
}

PyObject* NewXml(sml::ClientXML* xml) {
  if (!xml) return NewNone();
  return SWIG_NewPointerObj(new sml::ClientXML(xml), SWIGTYPE_p_sml__ClientXML, SWIG_POINTER_OWN);
}

}  // namespace soarbox::python
%}

%soarbox_forgets(Agent, UnregisterForRunEvent)
%soarbox_forgets(Agent, UnregisterForProductionEvent)
%soarbox_forgets(Agent, UnregisterForPrintEvent)
%soarbox_forgets(Agent, UnregisterForXMLEvent)
%soarbox_forgets(Agent, UnregisterForOutputNotification)
%soarbox_forgets(Agent, RemoveOutputHandler)
%soarbox_forgets(Kernel, UnregisterForSystemEvent)
%soarbox_forgets(Kernel, UnregisterForUpdateEvent)
%soarbox_forgets(Kernel, UnregisterForStringEvent)
%soarbox_forgets(Kernel, UnregisterForAgentEvent)
%soarbox_forgets(Kernel, RemoveRhsFunction)
%soarbox_forgets(Kernel, UnregisterForClientMessageEvent)

%pythoncode %{
def _record(kernel, file):
    """Records what this program does to the kernel's agents, from before the first one on.

    The file is a recording: `soarbox replay`, `why`, `inspect`, `compare` and `resume` open it. Raises OSError if it
    cannot be made.
    """
    problem = kernel.Record(str(file))
    if problem:
        raise OSError(problem)


Kernel.record = _record
%}
