// SPDX-License-Identifier: BSD-2-Clause
#include "callbacks.h"

#include <atomic>

#include "handles.h"
#include "text.h"

namespace soarbox::java {

using bindings::KernelEntry;

namespace {

/// Maximum depth of handlers that call the library, which calls handlers again. The stack of a Java thread is small.
constexpr int kDeepest = 24;

JavaVM* machine = nullptr;
jclass handler_class = nullptr;
jmethodID handler_run = nullptr;
jmethodID handler_too_deep = nullptr;
std::atomic<bool> door_is_shut = false;

/// A thread of the library that was attached to the virtual machine. It is detached when it ends.
struct Attachment {
  ~Attachment() {
    if (attached && !door_is_shut) machine->DetachCurrentThread();
  }
  bool attached = false;
};

/// This thread's JNI environment; null if the virtual machine is ending.
JNIEnv* Environment() {
  if (door_is_shut) return nullptr;
  void* env = nullptr;
  if (machine->GetEnv(&env, JNI_VERSION_1_8) == JNI_OK) return static_cast<JNIEnv*>(env);
  if (machine->AttachCurrentThreadAsDaemon(&env, nullptr) != JNI_OK) return nullptr;
  static thread_local Attachment attachment;
  attachment.attached = true;
  return static_cast<JNIEnv*>(env);
}

/// An object of Java's class Handler. The library stores the address of this structure.
struct Callback : std::enable_shared_from_this<Callback> {
  Callback(JNIEnv* env, jobject handler, std::shared_ptr<KernelEntry> entry)
      : handler(env->NewGlobalRef(handler)), entry(std::move(entry)) {}
  ~Callback() {
    if (JNIEnv* env = Environment()) env->DeleteGlobalRef(handler);
  }
  Callback(const Callback&) = delete;
  Callback& operator=(const Callback&) = delete;

  /// The number of the agent or kernel that it is called for. It is always the same, so Java can reuse its object.
  template <typename T>
  jlong NumberOf(T* object) {
    const std::lock_guard lock(mutex_);
    Slot slot;
    if (!Find(number_, slot)) number_ = Give(object, bindings::Life::Of(object));
    return number_;
  }

  const jobject handler;
  const std::weak_ptr<KernelEntry> entry;

 private:
  std::mutex mutex_;
  jlong number_ = 0;
};

/// The arguments of a handler.
struct Told {
  int event = 0;
  sml::Kernel* kernel = nullptr;
  sml::Agent* agent = nullptr;
  sml::WMElement* element = nullptr;
  sml::ClientXML* xml = nullptr;
  const char* agent_name = nullptr;
  const char* first = nullptr;
  const char* second = nullptr;
  int number = 0;
};

/// Calls Java within a separate frame of local references.
std::string CallHandler(JNIEnv* env, Callback& callback, const Told& told) {
  if (env->PushLocalFrame(8) != 0) {
    env->ExceptionClear();
    return {};
  }
  jlong object = 0;
  if (told.agent) object = callback.NumberOf(told.agent);
  if (told.kernel) object = callback.NumberOf(told.kernel);
  jlong other = 0;
  if (told.element) other = Give(told.element, bindings::Life::Of(told.element));
  if (told.xml) {
    // A copy; Java releases it when the handler returns.
    auto* copy = new sml::ClientXML(told.xml);
    other = Add({copy, {}, std::shared_ptr<sml::ClientXML>(copy)});
  }
  jstring agent_name = NewText(env, told.agent_name);
  jstring first = NewText(env, told.first);
  jstring second = NewText(env, told.second);
  std::string text;
  // If there was no memory for the texts, an exception is already set.
  if (!env->ExceptionCheck()) {
    auto answer =
        static_cast<jstring>(env->CallStaticObjectMethod(handler_class, handler_run, callback.handler, told.event,
                                                         object, other, agent_name, first, second, told.number));
    if (answer && !env->ExceptionCheck()) text = TextOf(env, answer);
  }
  if (env->ExceptionCheck()) env->ExceptionClear();
  env->PopLocalFrame(nullptr);
  return text;
}

std::string Run(void* data, const Told& told) {
  const std::shared_ptr<KernelEntry> entry = static_cast<Callback*>(data)->entry.lock();
  if (!entry || !entry->Enter()) return {};
  // It may be dropped while it runs.
  const std::shared_ptr<Callback> callback = static_cast<Callback*>(data)->shared_from_this();
  std::string result;
  static thread_local int depth = 0;
  if (JNIEnv* env = Environment()) {
    // The result of the call that this handler interrupts.
    const bindings::Returned returned = bindings::LastReturned();
    const jlong given = LastGiven();
    if (depth < kDeepest) {
      ++depth;
      result = CallHandler(env, *callback, told);
      --depth;
    } else {
      env->CallStaticVoidMethod(handler_class, handler_too_deep, callback->handler, kDeepest);
      env->ExceptionClear();
    }
    bindings::LastReturned() = returned;
    LastGiven() = given;
  }
  entry->Leave(false);
  return result;
}

const char* NameOf(sml::Agent* agent) {
  return agent ? agent->GetAgentName() : nullptr;
}

void RunRun(sml::smlRunEventId id, void* data, sml::Agent* agent, sml::smlPhase phase) {
  Told told;
  told.event = id;
  told.agent = agent;
  told.number = phase;
  Run(data, told);
}
void RunProduction(sml::smlProductionEventId id, void* data, sml::Agent* agent, const char* rule,
                   const char* instantiation) {
  Told told;
  told.event = id;
  told.agent = agent;
  told.first = rule;
  told.second = instantiation;
  Run(data, told);
}
void RunPrint(sml::smlPrintEventId id, void* data, sml::Agent* agent, const char* message) {
  Told told;
  told.event = id;
  told.agent = agent;
  told.first = message;
  Run(data, told);
}
void RunXml(sml::smlXMLEventId id, void* data, sml::Agent* agent, sml::ClientXML* xml) {
  Told told;
  told.event = id;
  told.agent = agent;
  told.xml = xml;
  Run(data, told);
}
void RunOutput(void* data, sml::Agent* agent, const char* command, sml::WMElement* element) {
  Told told;
  told.agent_name = NameOf(agent);
  told.element = element;
  told.first = command;
  Run(data, told);
}
void RunOutputNotification(void* data, sml::Agent* agent) {
  Told told;
  told.agent = agent;
  Run(data, told);
}
void RunSystem(sml::smlSystemEventId id, void* data, sml::Kernel* kernel) {
  Told told;
  told.event = id;
  told.kernel = kernel;
  Run(data, told);
}
void RunUpdate(sml::smlUpdateEventId id, void* data, sml::Kernel* kernel, sml::smlRunFlags flags) {
  Told told;
  told.event = id;
  told.kernel = kernel;
  told.number = flags;
  Run(data, told);
}
std::string RunString(sml::smlStringEventId id, void* data, sml::Kernel* kernel, const char* text) {
  Told told;
  told.event = id;
  told.kernel = kernel;
  told.first = text;
  return Run(data, told);
}
void RunAgent(sml::smlAgentEventId id, void* data, sml::Agent* agent) {
  Told told;
  told.event = id;
  told.agent_name = NameOf(agent);
  Run(data, told);
}
std::string RunFunction(sml::smlRhsEventId id, void* data, sml::Agent* agent, const char* name, const char* argument) {
  Told told;
  told.event = id;
  told.agent_name = NameOf(agent);
  told.first = name;
  told.second = argument;
  return Run(data, told);
}

/// Creates a callback, passes it to `registers`, and stores it if the result is an id (not 0).
template <typename Registers>
int Register(sml::Kernel* kernel, unsigned long long agent_life, jobject handler, Registers registers) {
  JNIEnv* env = Environment();
  if (!env || !handler) return 0;
  const std::shared_ptr<KernelEntry> entry = KernelEntry::Of(kernel);
  return bindings::Register(entry, agent_life, std::make_shared<Callback>(env, handler, entry), registers);
}

std::recursive_mutex& Values() {
  static auto* mutex = new std::recursive_mutex;
  return *mutex;
}

}  // namespace

void CallLibrary(bindings::Call::Hold hold, const std::function<void()>& function) {
  bindings::Call call;
  if (!call.entry()) {
    const auto lock = HoldValues();
    function();
    return;
  }
  call.Now(hold, function);
  if (call.outermost()) call.entry()->DropLeavers();
}

std::unique_lock<std::recursive_mutex> HoldValues() {
  return std::unique_lock(Values());
}

bool Begin(JavaVM* java) {
  machine = java;
  JNIEnv* env = Environment();
  jclass type = env ? env->FindClass("sml/Handler") : nullptr;
  if (!type) return false;
  handler_class = static_cast<jclass>(env->NewGlobalRef(type));
  handler_run = env->GetStaticMethodID(handler_class, "run",
                                       "(Lsml/Handler;IJJLjava/lang/String;Ljava/lang/String;Ljava/lang/String;I)"
                                       "Ljava/lang/String;");
  handler_too_deep = handler_run ? env->GetStaticMethodID(handler_class, "tooDeep", "(Lsml/Handler;I)V") : nullptr;
  return handler_too_deep != nullptr;
}

void ShutDoor() {
  door_is_shut = true;
}

int OnRun(sml::Agent& agent, int event, jobject handler) {
  return Register(agent.GetKernel(), agent.GetLife(), handler, [&, id = bindings::RunEvent(event)](void* own) {
    return agent.RegisterForRunEvent(id, RunRun, own);
  });
}
int OnProduction(sml::Agent& agent, int event, jobject handler) {
  return Register(agent.GetKernel(), agent.GetLife(), handler, [&, id = bindings::ProductionEvent(event)](void* own) {
    return agent.RegisterForProductionEvent(id, RunProduction, own);
  });
}
int OnPrint(sml::Agent& agent, int event, jobject handler, bool ignore_own_echos) {
  return Register(agent.GetKernel(), agent.GetLife(), handler, [&, id = bindings::PrintEvent(event)](void* own) {
    return agent.RegisterForPrintEvent(id, RunPrint, own, ignore_own_echos);
  });
}
int OnXml(sml::Agent& agent, int event, jobject handler) {
  return Register(agent.GetKernel(), agent.GetLife(), handler, [&, id = bindings::XmlEvent(event)](void* own) {
    return agent.RegisterForXMLEvent(id, RunXml, own);
  });
}
int OnOutput(sml::Agent& agent, const char* attribute, jobject handler) {
  return Register(agent.GetKernel(), agent.GetLife(), handler,
                  [&](void* own) { return agent.AddOutputHandler(attribute, RunOutput, own); });
}
int OnOutputNotification(sml::Agent& agent, jobject handler) {
  return Register(agent.GetKernel(), agent.GetLife(), handler,
                  [&](void* own) { return agent.RegisterForOutputNotification(RunOutputNotification, own); });
}
int OnSystem(sml::Kernel& kernel, int event, jobject handler) {
  return Register(&kernel, 0, handler, [&, id = bindings::SystemEvent(event)](void* own) {
    return kernel.RegisterForSystemEvent(id, RunSystem, own);
  });
}
int OnUpdate(sml::Kernel& kernel, int event, jobject handler) {
  return Register(&kernel, 0, handler, [&, id = bindings::UpdateEvent(event)](void* own) {
    return kernel.RegisterForUpdateEvent(id, RunUpdate, own);
  });
}
int OnString(sml::Kernel& kernel, int event, jobject handler) {
  return Register(&kernel, 0, handler, [&, id = bindings::StringEvent(event)](void* own) {
    return kernel.RegisterForStringEvent(id, RunString, own);
  });
}
int OnAgent(sml::Kernel& kernel, int event, jobject handler) {
  return Register(&kernel, 0, handler, [&, id = bindings::AgentEvent(event)](void* own) {
    return kernel.RegisterForAgentEvent(id, RunAgent, own);
  });
}
int AddRhsFunction(sml::Kernel& kernel, const char* name, jobject handler) {
  return Register(&kernel, 0, handler, [&](void* own) { return kernel.AddRhsFunction(name, RunFunction, own); });
}
int OnClientMessage(sml::Kernel& kernel, const char* client, jobject handler) {
  return Register(&kernel, 0, handler,
                  [&](void* own) { return kernel.RegisterForClientMessageEvent(client, RunFunction, own); });
}

}  // namespace soarbox::java
