#include "base/error.h"
#include "model/readers.h"
namespace croquis::model { RawModel read_vrml(const std::filesystem::path& path) { fail("{}: not yet", path.string()); } }
