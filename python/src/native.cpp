// The compiled part of the Python package: cases go in as texts, runs come out. What is made of them for people is in
// Python, in python/bumpfoil/.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "bumpfoil/case/case_reader.hpp"
#include "bumpfoil/case/case_writer.hpp"
#include "bumpfoil/core/error.hpp"
#include "bumpfoil/core/version.hpp"
#include "bumpfoil/ensemble/parallel_runs.hpp"
#include "bumpfoil/experiments/cycle/result_quantities.hpp"
#include "bumpfoil/experiments/properties/properties.hpp"
#include "bumpfoil/experiments/properties/properties_report.hpp"
#include "bumpfoil/pages/report.hpp"
#include "bumpfoil/readers/vtk_export.hpp"
#include "bumpfoil/results/checksum.hpp"
#include "bumpfoil/results/quantity.hpp"
#include "bumpfoil/results/result_folder.hpp"
#include "bumpfoil/results/result_set.hpp"
#include "cycle_views.hpp"
#include "ensemble.hpp"
#include "run.hpp"
#include "running_stepper.hpp"
#include "stepper.hpp"
#include "watch.hpp"

namespace bumpfoil {
namespace {

namespace py = pybind11;

using Files = std::map<std::string, py::bytes>;

/// What the command line calls --force is an argument here.
Error as_python_says_it(const Error& error) {
  constexpr std::string_view option = "--force";
  std::vector<InputError> errors = error.errors();
  for (InputError& one : errors) {
    const std::size_t at = one.advice.find(option);
    if (at != std::string::npos) one.advice.replace(at, option.size(), "force=True");
  }
  return {error.kind(), std::move(errors)};
}

void translate(std::exception_ptr thrown) {  // NOLINT(performance-unnecessary-value-param): as pybind11 wants it
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const Error& thrown_error) {
    const Error error = as_python_says_it(thrown_error);
    py::list errors;
    for (const InputError& one : error.errors()) errors.append(format_error(one));
    const py::object type =
        py::module_::import("bumpfoil.errors").attr(error.kind() == ErrorKind::input ? "CaseError" : "FileError");
    PyErr_SetObject(type.ptr(), type(std::string(error.what()), errors).ptr());
  }
}

/// The case as its author wrote it or, where it was changed since, as it was understood.
std::string kept_text(const CaseSource& source, const Case& input) {
  return source.changes.empty() ? source.text : case_to_toml(input);
}

/// Runs without the lock of Python, which learns of the progress.
template <typename Running>
Run watched(const py::object& progress, const Running& running) {
  Watch watch(progress);
  Run result = [&] {
    const py::gil_scoped_release unlocked;
    return running([&](double fraction) { return watch.go_on(fraction); });
  }();
  watch.rethrow();
  return result;
}

Run run(const std::string& command, const CaseSource& source, const py::object& progress) {
  const Case input = read_source(source, {command});
  const std::string text = kept_text(source, input);
  return watched(progress, [&](const ProgressCallback& go_on) { return run_command(command, input, text, go_on); });
}

Run sweep(const CaseSource& source, const std::string& command, const std::vector<std::string>& over,
          std::optional<unsigned> threads, bool limits, const py::object& progress) {
  const Sweep grid = read_sweep(source, command, over, limits);
  const std::string text = kept_text(source, grid.cases.front());
  return watched(progress, [&](const ProgressCallback& go_on) {
    return run_sweep(grid, text, threads.value_or(available_threads()), go_on);
  });
}

std::unique_ptr<FolderEnsemble> open_ensemble(const CaseSource& source, std::filesystem::path folder,
                                              std::optional<unsigned> threads, std::optional<double> target_error,
                                              std::vector<std::string> limits, bool resumes, bool force) {
  const Case input = read_source(source, {"montecarlo"});
  return std::make_unique<FolderEnsemble>(
      input, EnsembleRequest{std::move(folder), threads, target_error, std::move(limits), resumes, force},
      provenance_of("montecarlo", kept_text(source, input)));
}

void run_samples(FolderEnsemble& ensemble, const py::object& progress) {
  Watch watch(progress);
  {
    const py::gil_scoped_release unlocked;
    ensemble.run([&](double fraction) { return watch.go_on(fraction); });
  }
  watch.rethrow();
}

Files files_of(const Run& run) {
  Files files;
  for (const ResultFile& file : run.files()) files.emplace(file.name, file.contents);
  return files;
}

/// Names of what each cycle, vibration or state of an experiment has in result.nc.
std::vector<std::string> quantity_names(const std::string& command) {
  return each(experiment_named(command).quantities, [](const VariableMeaning& one) { return one.name; });
}

/// The few quantities that short tables show: name, key, label, unit and its size in SI.
using Headlines = std::vector<std::tuple<std::string, std::string, std::string, std::string, double>>;

Headlines headlines_of(const std::vector<VariableMeaning>& quantities) {
  Headlines shown;
  for (const VariableMeaning& one : quantities) {
    if ((one.tags & tag::headline) == 0) continue;
    shown.emplace_back(one.name, one.key(), one.label, one.shown.name, one.shown.size);
  }
  return shown;
}

/// Of each cycle, vibration or state of an experiment.
Headlines headlines(const std::string& command) {
  return headlines_of(experiment_named(command).quantities);
}

/// Of an increment of a path.
Headlines headlines_of_increments() {
  return headlines_of(meanings_of(increment_quantities(Experiment::path)));
}

void save(const std::filesystem::path& path, const Files& files, bool force) {
  std::vector<std::string> names;
  names.reserve(files.size());
  for (const auto& [name, contents] : files) names.push_back(name);
  ResultFolder folder(path, force ? Existing::replace : Existing::refuse, names);
  for (const auto& [name, contents] : files) folder.stage(name, std::string_view(contents));
  folder.publish();
}

void write_report(const std::vector<std::filesystem::path>& folders, const std::string& page,
                  const std::filesystem::path& path, bool force) {
  write_file(path, fill_report(page, report_json(folders)), force ? Existing::replace : Existing::refuse);
}

}  // namespace
}  // namespace bumpfoil

PYBIND11_MODULE(_native, m) {
  using namespace bumpfoil;
  py::register_local_exception_translator(translate);
  m.attr("version") = std::string(version());
  m.attr("commit") = std::string(commit());

  py::class_<CaseSource>(m, "CaseSource")
      .def(py::init<std::string, std::string, std::vector<std::string>>(), py::arg("text"), py::arg("name"),
           py::arg("changes"))
      .def_readonly("text", &CaseSource::text)
      .def_readonly("name", &CaseSource::name)
      .def_readonly("changes", &CaseSource::changes)
      .def("toml", [](const CaseSource& source) { return case_to_toml(read_source(source)); })
      .def("json", [](const CaseSource& source) { return case_to_json(read_source(source)); })
      .def("check", check_source)
      .def("properties", [](const CaseSource& source) {
        const Case input = read_source(source);
        return properties_json(input, compute_properties(input));
      });
  py::class_<Run>(m, "Run")
      .def_readonly("command", &Run::command)
      .def_property_readonly("status", [](const Run& run) { return std::string(name_of(run.outcome.status)); })
      .def_property_readonly("warnings", [](const Run& run) { return run.outcome.warnings; })
      .def_property_readonly("failures", [](const Run& run) { return run.outcome.failures; })
      .def("files", files_of)
      .def("cycles", [](const py::object& run) { return cycle_views(run); });
  add_stepper(m);
  add_running_stepper(m);
  m.def("read_case_text", read_case_text);
  m.def("case_template", [](const std::string& name) { return case_template(name); });
  m.def("quantity_names", quantity_names);
  m.def("headlines", headlines);
  m.def("headlines_of_increments", headlines_of_increments);
  m.def("key_of", key_of);
  m.def("run", run);
  m.def("sweep", sweep);
  m.def("experiments", [] {
    return each(experiments(), [](const ExperimentInfo& experiment) { return std::string(experiment.name); });
  });
  m.def("swept_commands", swept_commands);
  py::class_<FolderEnsemble>(m, "FolderEnsemble")
      .def(py::init(&open_ensemble))
      .def("run", run_samples)
      .def("publish", [](FolderEnsemble& ensemble) {
        auto [status, failures] = ensemble.publish();
        return std::pair(std::string(name_of(status)), std::move(failures));
      });
  m.def("save", save);
  m.def("published_file", published_file);
  m.def("checksum", [](const py::bytes& bytes) { return xxh3_128(std::string_view(bytes)); });
  m.def("is_sealed", [](const py::bytes& text, const std::string& checksum) { return is_sealed(text, checksum); });
  m.def("write_report", write_report);
  m.def("write_vtk", [](const py::bytes& contents, const std::filesystem::path& folder, bool force) {
    return write_vtk(std::string(contents), "result.nc", folder, force ? Existing::replace : Existing::refuse);
  });
}
