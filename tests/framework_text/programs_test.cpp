// The listings of the source text (seed C, programs 2.1, 2.2, 2.3 and 2.7), with the underscores that print lost.
#include "texts.h"

namespace croquis::framework {
namespace {

// The minus signs are U+2212, as printed.
constexpr const char* program_2_2 = R"(component simple_render {
# Render-to-texture variables.

string render_target {
default "" ; # No render-target texture - render to framebuffer by default.
internal 1 ; # This hides the variable from the user interface.

} ;
int render_target_width {

default 0 ;
minimum −64 ;
maximum 1024 ;
internal 1 ;

} ;
int render_target_height {

default 0 ;
minimum −64 ;
maximum 1024 ;
internal 1 ;

} ;

# Color to use when clearing the framebuffer.

rgb clear_color {
default 0.5 0.5 0.5 ; # Default color - grey.
minimum 0.0 0.0 0.0 ; # “Minimum” color - black.
maximum 1.0 1.0 1.0 ; # “Maximum” color - white.

} ;

# Optional texture to apply to meshes in the scene.

texture texture {
default "images:*" ; # Use the first available image in the “images” directory.

} ;

# Names of vertex and fragment programs to use to render the scene.
# These strings must be specified in the pass definition (or when inheriting
# component descriptor). The specified programs will be used to render the scene.
# By using different programs, the simple render component may be used to
# render the scene in vastly different ways.

string vertex_program ;
string fragment_program ;

} ;
)";

constexpr const char* program_2_3 = R"(component render_phong : simple_render {
# The “modify” keyword can be used to modify properties of
# an already defined component variable.

modify vertex_program {
default "default:default_transform" ;
internal 1 ;

} ;
modify fragment_program {

default "default:phong" ;

internal 1 ;
} ;
modify clear_color {

default 0.5 0.5 0.5 ;
} ;
modify texture {

internal 1 ;
} ;

} ;
)";

constexpr const char* program_2_7 = R"(component copy_to_texture {
# Texture to copy the framebuffer contents to.

string texture { read_only 1 ; } ;

# If false, copies the color buffer, if true, copies the depth buffer.

bool depth { default false ; read_only 1 ; } ;
} ;
)";

// Not a listing: the second component of program 2.1, of which the text says that it has a texture variable.
constexpr const char* edge_detector = R"(
component edge_detect_depth_2nd_derivative { texture texture ; } ;
)";

constexpr const char* program_2_1 =
    R"(# First pass named phong_and_depth uses component render_phong to draw the scene.

pass render_phong phong_and_depth {
render_target "phong" ; # Render the scene into a texture instead of framebuffer.

} ;

# Second pass named edge_detect detects edges in depth texture generated in pass 1.

pass edge_detect_depth_2nd_derivative edge_detect {
texture "<generated>:phong_depth" ;

} ;
)";

Descriptors all_programs() {
    return descriptors_of(std::string(program_2_3) + program_2_2 + program_2_7 + edge_detector);
}

TEST(Programs, SimpleRenderHasItsVariables) {
    const Descriptors descriptors = all_programs();
    const ComponentDescriptor& component = descriptors.at("simple_render");
    EXPECT_EQ(component.core, "simple_render");
    EXPECT_EQ(component.parent, "");
    EXPECT_EQ(component.variable_names(),
              (std::vector<std::string>{"render_target", "render_target_width", "render_target_height", "clear_color",
                                        "texture", "vertex_program", "fragment_program"}));
    const VariableDescriptor& target = *component.find("render_target");
    EXPECT_EQ(target.type, VariableType::string);
    EXPECT_EQ(target.default_value, Value(std::string()));
    EXPECT_TRUE(target.internal);
    const VariableDescriptor& width = *component.find("render_target_width");
    EXPECT_EQ(width.type, VariableType::integer);
    EXPECT_EQ(width.default_value, Value(0));
    EXPECT_EQ(width.minimum, Value(-64));
    EXPECT_EQ(width.ui_minimum, Value(-64));
    EXPECT_EQ(width.maximum, Value(1024));
    EXPECT_EQ(width.ui_maximum, Value(1024));
    const VariableDescriptor& color = *component.find("clear_color");
    EXPECT_EQ(color.type, VariableType::rgb);
    EXPECT_EQ(color.default_value, Value(glm::vec3(0.5f)));
    EXPECT_EQ(color.minimum, Value(glm::vec3(0)));
    EXPECT_EQ(color.maximum, Value(glm::vec3(1)));
    EXPECT_FALSE(color.internal);
    EXPECT_EQ(component.find("texture")->type, VariableType::texture);
    EXPECT_EQ(component.find("texture")->default_value, Value(std::string("images:*")));
    EXPECT_EQ(component.find("vertex_program")->default_value, std::nullopt);
    EXPECT_EQ(component.find("render_target")->where.to_string(), "file:29:8");
}

TEST(Programs, RenderPhongModifiesWhatItInherits) {
    const Descriptors descriptors = all_programs();
    const ComponentDescriptor& component = descriptors.at("render_phong");
    EXPECT_EQ(component.core, "simple_render");
    EXPECT_EQ(component.parent, "simple_render");
    EXPECT_EQ(component.variable_names(), descriptors.at("simple_render").variable_names());
    EXPECT_EQ(component.find("fragment_program")->default_value, Value(std::string("default:phong")));
    EXPECT_TRUE(component.find("fragment_program")->internal);
    EXPECT_EQ(component.find("vertex_program")->default_value, Value(std::string("default:default_transform")));
    EXPECT_TRUE(component.find("texture")->internal);
    EXPECT_FALSE(descriptors.at("simple_render").find("texture")->internal);
    EXPECT_EQ(component.find("clear_color")->maximum, Value(glm::vec3(1)));
}

TEST(Programs, CopyToTextureIsReadOnly) {
    const Descriptors descriptors = all_programs();
    const ComponentDescriptor& component = descriptors.at("copy_to_texture");
    EXPECT_EQ(component.find("texture")->type, VariableType::string);
    EXPECT_TRUE(component.find("texture")->read_only);
    EXPECT_EQ(component.find("texture")->default_value, std::nullopt);
    EXPECT_EQ(component.find("depth")->default_value, Value(false));
    EXPECT_TRUE(component.find("depth")->read_only);
}

TEST(Programs, EdgeDetectorTechniqueHasTwoPasses) {
    const Descriptors descriptors = all_programs();
    const TechniqueDefinition technique = technique_of(program_2_1, descriptors);
    EXPECT_EQ(technique.pass_names(), (std::vector<std::string>{"phong_and_depth", "edge_detect"}));
    const PassDefinition& phong = technique.passes[0];
    EXPECT_EQ(phong.component, descriptors.find("render_phong"));
    EXPECT_EQ(phong.where.to_string(), "file:3:1");
    EXPECT_EQ(phong.values.size(), phong.component->variables.size());
    EXPECT_EQ(phong.values.at("render_target"), Value(std::string("phong")));
    EXPECT_EQ(phong.values.at("clear_color"), Value(glm::vec3(0.5f)));
    EXPECT_EQ(technique.passes[1].values.at("texture"), Value(std::string("<generated>:phong_depth")));
}

}  // namespace
}  // namespace croquis::framework
