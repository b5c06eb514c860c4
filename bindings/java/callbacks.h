// SPDX-License-Identifier: BSD-2-Clause
#pragma once

#include <jni.h>

#include <functional>

#include "call.h"

/// Objects of Java (class sml.Handler) as handlers of the library, and calls of the library from Java.
namespace soarbox::java {

/// Calls the library. Calls that concern no kernel take turns: several threads may share a piece of XML.
void CallLibrary(bindings::Call::Hold hold, const std::function<void()>& call);

/// Held while a piece of XML is changed inside a call that concerns a kernel.
std::unique_lock<std::recursive_mutex> HoldValues();

/// Learns of the virtual machine and of Java's class Handler; false with an exception in Java if there is none.
bool Begin(JavaVM* machine);
/// Stops all runs and shuts all kernels down; may wait for handlers.
using bindings::EndKernels;
/// No handler goes into Java any more: the virtual machine is about to end.
void ShutDoor();

/// Register an object of the class Handler. They return the id; 0 if the library refuses. They throw
/// std::invalid_argument if the event is none of this kind.
int OnRun(sml::Agent& agent, int event, jobject handler);
int OnProduction(sml::Agent& agent, int event, jobject handler);
int OnPrint(sml::Agent& agent, int event, jobject handler, bool ignore_own_echos);
int OnXml(sml::Agent& agent, int event, jobject handler);
int OnOutput(sml::Agent& agent, const char* attribute, jobject handler);
int OnOutputNotification(sml::Agent& agent, jobject handler);
int OnSystem(sml::Kernel& kernel, int event, jobject handler);
int OnUpdate(sml::Kernel& kernel, int event, jobject handler);
int OnString(sml::Kernel& kernel, int event, jobject handler);
int OnAgent(sml::Kernel& kernel, int event, jobject handler);
int AddRhsFunction(sml::Kernel& kernel, const char* name, jobject handler);
int OnClientMessage(sml::Kernel& kernel, const char* client, jobject handler);

/// Forgets what was registered under an id, after the library has.
using bindings::Forget;

}  // namespace soarbox::java
