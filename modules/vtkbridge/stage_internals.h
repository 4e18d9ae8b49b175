// The inside of vtkBoleStage.
#pragma once

#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "pipeline/stage.h"
#include "vtkBoleStage.h"
#include "vtkType.h"
#include "vtkbridge/core_conversion.h"
#include "vtkbridge/stage_control.h"
#include "vtkbridge/stage_execution.h"

class vtkDataObject;
class vtkInformation;
class vtkInformationVector;

namespace bole::vtkbridge {

int port_index(const std::vector<pipeline::Port>& ports, const char* name);
std::string port_name(const std::vector<pipeline::Port>& ports, int index);  // empty when there is none
std::string port_list(const std::vector<pipeline::Port>& ports);

// Asks of other threads to the stage that runs now.
class StopRequests {
 public:
  // New tokens for a new execution.
  void begin();
  void cancel();
  void finish();
  std::stop_token cancel_token();
  std::stop_token finish_token();

 private:
  std::mutex mutex_;
  std::stop_source cancel_, finish_;
};

}  // namespace bole::vtkbridge

class vtkBoleStage::Internals {
 public:
  std::string wanted_type;
  const bole::pipeline::StageType* type = nullptr;
  std::optional<bole::OptionSet> options;
  bole::vtkbridge::StageControl control;
  bole::vtkbridge::StopRequests stop;
  bool vertices = true;
  bool place_points = false;
  std::shared_ptr<bole::vtkbridge::LazyData> given;  // in place of a file

  std::optional<bole::vtkbridge::StageExecution> result;  // of the options and inputs as they stood at `result_time`
  int executions = 0;
  int exit_code = 0;
  std::string error_text;

  const bole::OptionSpec& spec(const char* name) const;
  void change_option(vtkBoleStage* self, const char* name, const bole::OptionValue& value);

  // Runs `work`; an Error becomes the stage's error. True when there was none.
  bool guarded(vtkBoleStage* self, const std::function<void()>& work);
  // The same for setters: what they refuse says nothing about the last execution.
  bool accepted(vtkBoleStage* self, const std::function<void()>& work);
  void fail(vtkBoleStage* self, const bole::Error& error);

  // The core object behind an input; null when a stage before had nothing to give and the input is optional.
  std::shared_ptr<bole::vtkbridge::LazyData> input(int port, vtkDataObject* object);
  // Brings `result` up to date: executes when options or inputs differ from those of the last time. False after an
  // error.
  bool update(vtkBoleStage* self, const bole::vtkbridge::PortData& inputs, const bole::Piece& piece = {});
  // Puts an output into its VTK object.
  void fill(int port, vtkDataObject* object, std::size_t step, bool core_only);

  // The piece that a request asks for: of a stage that gives no pieces, piece 0 is everything and the others are empty.
  static bole::Piece piece_wanted(vtkInformation* output);
  // Whether a source has the path of its file. Programs such as ParaView look at a source before they name one.
  bool has_path() const;

  // Frames and views as VTK time steps; other outputs have none.
  void tell_times(const bole::pipeline::Port& port, vtkInformation* info);
  void tell_extent(vtkDataObject* object, vtkInformation* info);
  // After a run: how large an image is. What VTK was told before is then asked for again by tell_again() at the next
  // update; a change of time during a run counts as part of it and goes unnoticed.
  void tell_new_extents(vtkInformationVector* outputs);
  void tell_again(vtkBoleStage* self);
  std::size_t step_wanted(int port, vtkInformation* info);

 private:
  bole::Run make_run(vtkBoleStage* self);
  bool is_current(const vtkBoleStage* self, const bole::vtkbridge::PortData& inputs) const;
  void take_up_piece(const bole::Piece& piece);
  bole::vtkbridge::StageExecution execute(vtkBoleStage* self, const bole::vtkbridge::PortData& inputs);
  std::vector<double> step_times_s(const std::string& port);

  bool new_extents_ = false;
  vtkMTimeType result_time_ = 0;
  bole::vtkbridge::PortData result_inputs_;
  bole::Piece piece_;  // of `result`
  // The result before, of another piece: a view asks for pieces and a filter for the whole, in turns.
  struct {
    std::optional<bole::vtkbridge::StageExecution> result;
    vtkMTimeType time = 0;
    bole::vtkbridge::PortData inputs;
    bole::Piece piece;
  } spare_;
};
