// SPDX-License-Identifier: BSD-2-Clause
// Package sml: the client API of Soar 9.6 as Java programs expect it.
%module sml

%header %{
#include "callbacks.h"
#include "handles.h"
#include "text.h"
%}

%pragma(java) jniclasscode=%{
  static {
    Library.load();
  }
%}
%native(release) void release(jlong handle);
%native(endKernels) void endKernels();
%native(shutDoor) void shutDoor();
%wrapper %{
SWIGEXPORT void JNICALL Java_sml_smlJNI_release(JNIEnv*, jclass, jlong handle) {
  soarbox::java::Release(handle);
}
SWIGEXPORT void JNICALL Java_sml_smlJNI_endKernels(JNIEnv*, jclass) {
  soarbox::java::EndKernels();
}
SWIGEXPORT void JNICALL Java_sml_smlJNI_shutDoor(JNIEnv*, jclass) {
  soarbox::java::ShutDoor();
}
SWIGEXPORT jint JNICALL JNI_OnLoad(JavaVM* machine, void*) {
  return soarbox::java::Begin(machine) ? JNI_VERSION_1_8 : JNI_ERR;
}
%}

// Objects are numbers (handles.h). No class has a pointer; the garbage collector releases unused objects.
%typemap(javabody) SWIGTYPE %{
  final long swigCPtr;

  $javaclassname(long handle, boolean own) {
    swigCPtr = handle;
    Handles.watch(this, handle);
  }

  static long getCPtr($javaclassname object) {
    return object == null ? 0 : object.swigCPtr;
  }
%}
%typemap(javabody_derived) SWIGTYPE %{
  $javaclassname(long handle, boolean own) {
    super(handle, own);
  }

  static long getCPtr($javaclassname object) {
    return object == null ? 0 : object.swigCPtr;
  }
%}
%typemap(javafinalize) SWIGTYPE ""
%typemap(javaconstruct) SWIGTYPE {
    this($imcall, true);
  }
%typemap(javadestruct, methodname="delete", methodmodifiers="public", parameters="") SWIGTYPE {
    Handles.release(swigCPtr);
  }
%typemap(javadestruct_derived, methodname="delete", methodmodifiers="public", parameters="") SWIGTYPE {
    Handles.release(swigCPtr);
  }
%typemap(in, canthrow=1) SWIGTYPE * (soarbox::java::Reached< $*1_ltype > reached), SWIGTYPE & (soarbox::java::Reached< $*1_ltype > reached) %{
  $1 = reached.At(jenv, $input, "$symname");
  if (!$1) return $null;
%}
%typemap(out) SWIGTYPE *, SWIGTYPE & %{ $result = soarbox::java::LastGiven(); %}
// Soar has no such constructor: new ClientXML(null) would be ambiguous.
%ignore sml::ClientXML::ClientXML(soarxml::ElementXML const &);
%ignore sml::ClientErrors::~ClientErrors;
%ignore sml::Kernel::~Kernel;
%ignore sml::Agent::~Agent;
%ignore sml::WMElement::~WMElement;
%ignore sml::StringElement::~StringElement;
%ignore sml::IntElement::~IntElement;
%ignore sml::FloatElement::~FloatElement;
%ignore sml::Identifier::~Identifier;
%ignore sml::IdentifierSymbol::~IdentifierSymbol;
%ignore sml::ClientXML::~ClientXML;
%ignore sml::ClientTraceXML::~ClientTraceXML;
%ignore sml::ClientAnalyzedXML::~ClientAnalyzedXML;
%ignore soarxml::ElementXML::~ElementXML;
%nodefaultdtor;
%define %soarbox_shared(TYPE...)
%enddef

// The Java class of an element depends on its type.
%typemap(javaout) sml::WMElement * {
    return Handles.element($jnicall);
  }

// Texts are UTF-8 in the library. A text may be null only if the library accepts a null pointer.
%typemap(in, canthrow=1) char * (soarbox::java::Text text) %{
  if (!text.Take(jenv, $input, "$symname")) return $null;
  $1 = text.c_str();
%}
%typemap(in, canthrow=1) char const *pIPaddress (soarbox::java::Text text), char const *jarpath (soarbox::java::Text text), char const *pAgentName (soarbox::java::Text text) %{
  if (!text.Take(jenv, $input, "$symname", soarbox::java::Text::Null::kAllowed)) return $null;
  $1 = text.c_str();
%}
%typemap(freearg) char *, char const *pIPaddress, char const *jarpath, char const *pAgentName ""
%typemap(out) char * %{ $result = soarbox::java::NewText(jenv, static_cast<const char *>($1)); %}
%define %soarbox_after_shared
%typemap(in, canthrow=1) std::string (soarbox::java::Text text) %{
  if (!text.Take(jenv, $input, "$symname")) return $null;
  $1 = text.str();
%}
%typemap(in, canthrow=1) std::string const & (soarbox::java::Text text, std::string copy) %{
  if (!text.Take(jenv, $input, "$symname")) return $null;
  copy = text.str();
  $1 = &copy;
%}
%typemap(out) std::string %{ $result = soarbox::java::NewText(jenv, std::string_view($1)); %}
%typemap(out) std::string const & %{ $result = soarbox::java::NewText(jenv, std::string_view(*$1)); %}
%enddef

%define %soarbox_call(NAME, HOLD, CHECK)
%exception NAME {
  CHECK
  try {
    soarbox::java::CallLibrary(soarbox::bindings::Call::Hold::HOLD, [&] {
      $action
      soarbox::bindings::TakeHome(result);
      soarbox::java::GiveReturned(result);
    });
  } catch (const std::exception&) {
    soarbox::java::ThrowCaught(jenv);
    return $null;
  }
}
%enddef
%exception {
  try {
    soarbox::java::CallLibrary(soarbox::bindings::Call::Hold::kKernel, [&] {
      $action
      soarbox::bindings::TakeHome(result);
      soarbox::java::GiveReturned(result);
    });
  } catch (const std::exception&) {
    soarbox::java::ThrowCaught(jenv);
    return $null;
  }
}
%soarbox_call(sml::Agent::SoarboxStop, kNothing, )
%soarbox_call(sml::Kernel::StopAllAgents, kNothing, )
%soarbox_call(sml::Kernel::IsSoarRunning, kNothing, )
%soarbox_call(sml::Kernel::IsConnectionClosed, kNothing, )
%soarbox_call(sml::Kernel::IsRemoteConnection, kNothing, )
%soarbox_call(sml::Kernel::IsDirectConnection, kNothing, )
%soarbox_call(sml::Kernel::StartEventThread, kNothing, )
%soarbox_call(sml::Kernel::StopEventThread, kNothing, )
%define %soarbox_require_name
  if (!arg2) {
    soarbox::java::Throw(jenv, soarbox::java::Problem::kNull, "the name of the agent is null");
    return $null;
  }
%enddef
%soarbox_call(sml::Kernel::CreateAgent, kKernel, %soarbox_require_name)
%soarbox_call(sml::Kernel::GetAgent, kKernel, %soarbox_require_name)

// Handlers of a kernel that was shut down are released.
%rename(ShutdownInternal) sml::Kernel::Shutdown;
%exception sml::Kernel::Shutdown {
  try {
    soarbox::java::CallLibrary(soarbox::bindings::Call::Hold::kNothing, [&] {
      $action
      soarbox::bindings::Call::Near()->entry->DropAll();
    });
  } catch (const std::exception&) {
    soarbox::java::ThrowCaught(jenv);
    return $null;
  }
}
// An agent that no longer exists is not valid.
%exception sml::Kernel::IsAgentValid {
  try {
    soarbox::java::CallLibrary(soarbox::bindings::Call::Hold::kKernel, [&] { $action });
  } catch (const soarbox::bindings::Gone&) {
    result = false;
  } catch (const std::invalid_argument&) {
    result = false;
  } catch (const std::exception&) {
    soarbox::java::ThrowCaught(jenv);
    return $null;
  }
}

// A kernel exists until it is shut down or deleted, even if references remain.
%define %soarbox_factory(NAME)
%exception sml::Kernel::NAME {
  try {
    $action
    soarbox::bindings::TakeHome(result);
    soarbox::java::LastGiven() = soarbox::java::GiveOwned(result, *soarbox::bindings::LastReturned().life);
  } catch (const std::exception&) {
    soarbox::java::ThrowCaught(jenv);
    return $null;
  }
}
%typemap(javaout) sml::Kernel *NAME {
    return Kernel.keep(new Kernel($jnicall, true));
  }
%enddef
%soarbox_factory(CreateKernelInCurrentThread)
%soarbox_factory(CreateKernelInNewThread)
%soarbox_factory(CreateRemoteConnection)
%typemap(javadestruct_derived, methodname="delete", methodmodifiers="public", parameters="") sml::Kernel {
    KERNELS.remove(this);
    Handles.release(swigCPtr);
  }

%javamethodmodifiers sml::Agent::onRun "";
%javamethodmodifiers sml::Agent::onProduction "";
%javamethodmodifiers sml::Agent::onPrint "";
%javamethodmodifiers sml::Agent::onXml "";
%javamethodmodifiers sml::Agent::onOutput "";
%javamethodmodifiers sml::Agent::onOutputNotification "";
%javamethodmodifiers sml::Kernel::onSystem "";
%javamethodmodifiers sml::Kernel::onUpdate "";
%javamethodmodifiers sml::Kernel::onString "";
%javamethodmodifiers sml::Kernel::onAgent "";
%javamethodmodifiers sml::Kernel::addFunction "";
%javamethodmodifiers sml::Kernel::onClientMessage "";
%extend sml::Agent {
  int onRun(int event, jobject handler) { return soarbox::java::OnRun(*$self, event, handler); }
  int onProduction(int event, jobject handler) { return soarbox::java::OnProduction(*$self, event, handler); }
  int onPrint(int event, jobject handler, bool ignoreOwnEchos) {
    return soarbox::java::OnPrint(*$self, event, handler, ignoreOwnEchos);
  }
  int onXml(int event, jobject handler) { return soarbox::java::OnXml(*$self, event, handler); }
  int onOutput(char const *pAttributeName, jobject handler) {
    return soarbox::java::OnOutput(*$self, pAttributeName, handler);
  }
  int onOutputNotification(jobject handler) { return soarbox::java::OnOutputNotification(*$self, handler); }
}
%extend sml::Kernel {
  int onSystem(int event, jobject handler) { return soarbox::java::OnSystem(*$self, event, handler); }
  int onUpdate(int event, jobject handler) { return soarbox::java::OnUpdate(*$self, event, handler); }
  int onString(int event, jobject handler) { return soarbox::java::OnString(*$self, event, handler); }
  int onAgent(int event, jobject handler) { return soarbox::java::OnAgent(*$self, event, handler); }
  int addFunction(char const *pRhsFunctionName, jobject handler) {
    return soarbox::java::AddRhsFunction(*$self, pRhsFunctionName, handler);
  }
  int onClientMessage(char const *pClientName, jobject handler) {
    return soarbox::java::OnClientMessage(*$self, pClientName, handler);
  }
}

// The library removes a handler before the binding drops it.
%define %soarbox_forgets(CLASS, NAME)
%extend sml::CLASS {
  %rename(NAME) Soarbox##NAME;
  bool Soarbox##NAME(long long callbackID) {
    const int id = static_cast<int>(callbackID);
    if (id != callbackID || !$self->NAME(id)) return false;
    soarbox::java::Forget(*$self, id);
    return true;
  }
}
%enddef

// Other threads may read the answer in the meantime, so it is replaced at the end in one step.
%header %{
namespace {
struct OpenAnswer : sml::ClientAnalyzedXML {
  void Show(sml::ClientAnalyzedXML *response) const {
    const auto lock = soarbox::java::HoldValues();
    response->Attach(answer_);
  }
};
}  // namespace
%}
%ignore sml::Agent::ExecuteCommandLineXML;
%ignore sml::Kernel::ExecuteCommandLineXML;
%extend sml::Agent {
  %rename(ExecuteCommandLineXML) SoarboxXmlLine;
  bool SoarboxXmlLine(char const *pCommandLine, sml::ClientAnalyzedXML *pResponse) {
    OpenAnswer answer;
    const bool succeeded = $self->ExecuteCommandLineXML(pCommandLine, &answer);
    answer.Show(pResponse);
    return succeeded;
  }
}
%extend sml::Kernel {
  %rename(ExecuteCommandLineXML) SoarboxXmlLine;
  bool SoarboxXmlLine(char const *pCommandLine, char const *pAgentName, sml::ClientAnalyzedXML *pResponse) {
    OpenAnswer answer;
    const bool succeeded = $self->ExecuteCommandLineXML(pCommandLine, pAgentName, &answer);
    answer.Show(pResponse);
    return succeeded;
  }
}

%typemap(javacode) sml::Agent %{
  public interface RunEventInterface {
    void runEventHandler(int eventID, Object data, Agent agent, int phase);
  }
  public interface ProductionEventInterface {
    void productionEventHandler(int eventID, Object data, Agent agent, String prodName, String instantiation);
  }
  public interface PrintEventInterface {
    void printEventHandler(int eventID, Object data, Agent agent, String message);
  }
  public interface xmlEventInterface {
    void xmlEventHandler(int eventID, Object data, Agent agent, ClientXML xml);
  }
  public interface OutputEventInterface {
    void outputEventHandler(Object data, String agentName, String attributeName, WMElement pWmeAdded);
  }
  public interface OutputNotificationInterface {
    void outputNotificationHandler(Object data, Agent agent);
  }

  public long RegisterForRunEvent(smlRunEventId id, RunEventInterface handler, Object data) {
    return onRun(Handler.event(id).swigValue(), new Handler("a run event", handler, told -> {
      handler.runEventHandler(told.event, data, told.agent(), told.number);
      return null;
    }));
  }
  public long RegisterForProductionEvent(smlProductionEventId id, ProductionEventInterface handler, Object data) {
    return onProduction(Handler.event(id).swigValue(), new Handler("a production event", handler, told -> {
      handler.productionEventHandler(told.event, data, told.agent(), told.first, told.second);
      return null;
    }));
  }
  public long RegisterForPrintEvent(smlPrintEventId id, PrintEventInterface handler, Object data) {
    return RegisterForPrintEvent(id, handler, data, true);
  }
  public long RegisterForPrintEvent(smlPrintEventId id, PrintEventInterface handler, Object data,
                                    boolean ignoreOwnEchos) {
    return onPrint(Handler.event(id).swigValue(), new Handler("a print event", handler, told -> {
      handler.printEventHandler(told.event, data, told.agent(), told.first);
      return null;
    }), ignoreOwnEchos);
  }
  public long RegisterForXMLEvent(smlXMLEventId id, xmlEventInterface handler, Object data) {
    return onXml(Handler.event(id).swigValue(), new Handler("an XML event", handler, told -> {
      handler.xmlEventHandler(told.event, data, told.agent(), told.xml());
      return null;
    }));
  }
  public long AddOutputHandler(String attributeName, OutputEventInterface handler, Object data) {
    return onOutput(attributeName, new Handler("output", handler, told -> {
      handler.outputEventHandler(data, told.agentName, told.first, told.element());
      return null;
    }));
  }
  public long RegisterForOutputNotification(OutputNotificationInterface handler, Object data) {
    return onOutputNotification(new Handler("an output notification", handler, told -> {
      handler.outputNotificationHandler(data, told.agent());
      return null;
    }));
  }
%}

%typemap(javacode) sml::Kernel %{
  private static final java.util.Set<Kernel> KERNELS = java.util.concurrent.ConcurrentHashMap.newKeySet();

  static Kernel keep(Kernel kernel) {
    KERNELS.add(kernel);
    return kernel;
  }

  public interface SystemEventInterface {
    void systemEventHandler(int eventID, Object data, Kernel kernel);
  }
  public interface UpdateEventInterface {
    void updateEventHandler(int eventID, Object data, Kernel kernel, int runFlags);
  }
  public interface StringEventInterface {
    String stringEventHandler(int eventID, Object data, Kernel kernel, String callbackData);
  }
  public interface AgentEventInterface {
    void agentEventHandler(int eventID, Object data, String agentName);
  }
  public interface RhsFunctionInterface {
    String rhsFunctionHandler(int eventID, Object data, String agentName, String functionName, String argument);
  }
  public interface ClientMessageInterface {
    String clientMessageHandler(int eventID, Object data, String agentName, String clientName, String message);
  }

  /** Destroys the kernel and its agents; disconnects from a remote one. Afterwards, call only delete(). */
  public void Shutdown() {
    ShutdownInternal();
    KERNELS.remove(this);
  }
  public void ShutdownNoDelete() {
    Shutdown();
  }

  public long RegisterForSystemEvent(smlSystemEventId id, SystemEventInterface handler, Object data) {
    return onSystem(Handler.event(id).swigValue(), new Handler("a system event", handler, told -> {
      handler.systemEventHandler(told.event, data, told.kernel());
      return null;
    }));
  }
  public long RegisterForUpdateEvent(smlUpdateEventId id, UpdateEventInterface handler, Object data) {
    return onUpdate(Handler.event(id).swigValue(), new Handler("an update event", handler, told -> {
      handler.updateEventHandler(told.event, data, told.kernel(), told.number);
      return null;
    }));
  }
  public long RegisterForStringEvent(smlStringEventId id, StringEventInterface handler, Object data) {
    return onString(Handler.event(id).swigValue(), new Handler("a string event", handler,
        told -> handler.stringEventHandler(told.event, data, told.kernel(), told.first)));
  }
  public long RegisterForAgentEvent(smlAgentEventId id, AgentEventInterface handler, Object data) {
    return onAgent(Handler.event(id).swigValue(), new Handler("an agent event", handler, told -> {
      handler.agentEventHandler(told.event, data, told.agentName);
      return null;
    }));
  }
  public long AddRhsFunction(String functionName, RhsFunctionInterface handler, Object data) {
    return addFunction(functionName, new Handler("a right-hand-side function", handler,
        told -> handler.rhsFunctionHandler(told.event, data, told.agentName, told.first, told.second)));
  }
  public long RegisterForClientMessageEvent(String clientName, ClientMessageInterface handler, Object data) {
    return onClientMessage(clientName, new Handler("a client message", handler,
        told -> handler.clientMessageHandler(told.event, data, told.agentName, told.first, told.second)));
  }
%}

// Java has its own strings.
%typemap(javacode) sml::ClientXML, sml::ClientAnalyzedXML %{
  /** Does nothing. It exists for programs that call it as in C++. */
  public static void DeleteString(String text) {}
%}
%typemap(javacode) soarxml::ElementXML %{
  /** Does nothing. It exists for programs that call it as in C++. */
  public static void DeleteString(String text) {}
  /** The same as SetTagName(tagName). The name is always copied; copyName has no effect. */
  public boolean SetTagName(String tagName, boolean copyName) {
    return SetTagName(tagName);
  }
  public void addAttribute(String name, String value) {
    AddAttribute(name, value);
  }
  public String getAttributeThrows(String name) throws Exception {
    String value = GetAttribute(name);
    if (value == null) throw new Exception("The element " + GetTagName() + " has no attribute " + name);
    return value;
  }
  public int getAttributeIntThrows(String name) throws Exception {
    return Integer.parseInt(getAttributeThrows(name));
  }
%}

// The constants of the protocol are functions in Java: sml_Names.getKParamValue().
#define SOARBOX_PUBLIC_API_ONLY
#define EXPORT
#define constexpr
%immutable;
%include "sml_Names.h"
%mutable;
#undef constexpr

%include "../sml.i"

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
