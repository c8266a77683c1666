// Descriptor files: any bytes give descriptors that agree with themselves, or an Error.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "base/error.h"
#include "framework/descriptor.h"

using namespace croquis;
using namespace croquis::framework;

namespace {

// What every user of a descriptor relies on.
void check(const ComponentDescriptor& component) {
    for (const VariableDescriptor& variable : component.variables) {
        if (component.find(variable.name) != &variable) std::abort();
        if (!variable.default_value) continue;
        const FittedValue fitted = fit_to_range(variable, *variable.default_value);
        if (!fitted.warning.empty() || !fitted.error.empty()) std::abort();
    }
}

}  // namespace

// A line `---` separates the shipped layer from the user's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::size_t cut = text.find("\n---\n");
    std::vector<std::vector<Descriptors::Source>> layers{{{"shipped", text.substr(0, cut)}}};
    if (cut != std::string::npos) layers.push_back({{"users", text.substr(cut + 5)}});
    try {
        const Descriptors descriptors(layers);
        for (const std::string& name : descriptors.names()) check(descriptors.at(name));
    } catch (const Error& error) {
        if (std::string(error.what()).empty()) std::abort();
    }
    return 0;
}
