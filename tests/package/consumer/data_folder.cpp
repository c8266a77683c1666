// Prints the folder of the shipped data; an error of the library is caught by its type, across the library's border.
#include <croquis/croquis.h>

#include <iostream>

int main() {
    croquis::Renderer renderer = croquis::Renderer::headless();
    try {
        (void)renderer.open_technique("cartoom");
    } catch (const croquis::Error& error) {
        std::cout << renderer.info().data_folders.back() << "\n" << error.what() << "\n";
    }
}
