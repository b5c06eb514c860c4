# SPDX-License-Identifier: BSD-2-Clause
# Compiles what SWIG made (MADE) and what is ours (OWN) into CLASSES, and packs RESULT.
file(GLOB sources "${MADE}/*.java" "${OWN}/*.java")
file(REMOVE_RECURSE "${CLASSES}")
execute_process(COMMAND "${JAVAC}" --release 11 -encoding UTF-8 -d "${CLASSES}" ${sources} COMMAND_ERROR_IS_FATAL ANY)
file(WRITE "${CLASSES}/manifest" "Implementation-Title: Soarbox\nImplementation-Version: ${VERSION}\n")
execute_process(COMMAND "${JAR}" --create --file "${RESULT}" --manifest "${CLASSES}/manifest" -C "${CLASSES}" sml
                COMMAND_ERROR_IS_FATAL ANY)
