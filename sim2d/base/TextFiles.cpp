#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>
#include <system_error>
#include <utility>

#include "sim2d/base/FileSet.h"
#include "sim2d/base/NewFile.h"
#include "sim2d/base/Text.h"

namespace base {
namespace {

namespace fs = std::filesystem;

/// The content on the disk under a name of its own.
Diagnostics prepare(const FileContent& file, std::vector<std::unique_ptr<NewFile>>& made) {
  Diagnostics problems;
  std::unique_ptr<NewFile> part = NewFile::open(file.path, problems);
  if (!part) {
    return problems;
  }
  std::error_code error = part->write(file.content);
  if (!error) {
    error = part->toDisk();
  }
  made.push_back(std::move(part));
  return error ? Diagnostics{fileError("file.cannot-write", file.path, error)} : Diagnostics();
}

}  // namespace

Result<std::string> readTextFile(const std::string& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status)) {
    return fileError("file.cannot-read", path,
                     error ? error : std::make_error_code(std::errc::no_such_file_or_directory));
  }
  if (fs::is_directory(status)) {
    return fileError("file.cannot-read", path, std::make_error_code(std::errc::is_a_directory));
  }
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    return fileError("file.cannot-read", path, lastError());
  }
  std::string content{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  if (stream.bad()) {
    return fileError("file.cannot-read", path, lastError());
  }
  return content;
}

Diagnostics writeFileAtomically(const std::string& path, std::string_view content) {
  return writeFilesTogether({{path, std::string(content)}});
}

Diagnostics writeFilesTogether(const std::vector<FileContent>& files) {
  Diagnostics problems;
  std::vector<std::unique_ptr<NewFile>> made;
  std::set<std::string> told;  // a folder that cannot be made, once
  for (const FileContent& file : files) {
    for (Diagnostic& problem : prepare(file, made)) {
      if (told.insert(problem.text()).second) {
        problems.push_back(std::move(problem));
      }
    }
  }
  if (!problems.empty()) {
    return problems;
  }
  for (std::size_t i = 0; i < made.size(); ++i) {
    std::error_code error;
    if (i + 1 < made.size()) {  // nothing can go wrong any more after the last one
      error = made[i]->keepOld();
    }
    if (!error) {
      error = made[i]->putInPlace();
    }
    if (error) {
      problems.push_back(fileError("file.cannot-write", files[i].path, error));
      for (std::size_t done = i; done-- > 0;) {
        if (const std::error_code lost = made[done]->takeBack()) {
          problems.push_back(fileError("file.cannot-restore", files[done].path, lost));
        }
      }
      break;
    }
  }
  return problems;
}

}  // namespace base
