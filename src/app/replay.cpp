// SPDX-License-Identifier: BSD-2-Clause
#include "app/data_folders.h"
#include "app/open_recording.h"
#include "app/recording_commands.h"
#include "app/refuse.h"
#include "app/run_session.h"
#include "app/window.h"

namespace soarbox::app {

int Replay(const RecordingOptions& options) {
  Result<std::unique_ptr<record::Reader>> reader = OpenRecording(options.file);
  if (!reader) return Refuse(reader.error());
  const Result<sim::DataFolders> data = FindDataFolders();
  if (!data) return Refuse(data.error());
  CatchInterrupts();
  return ProgramWindow()->Replay(**reader, RangeOf(**reader, options), *data, options);
}

}  // namespace soarbox::app
