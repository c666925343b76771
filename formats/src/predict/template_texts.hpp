// SPDX-License-Identifier: MIT
// The files of templates/ as they were when the library was built.
#ifndef SINEW_FORMATS_PREDICT_TEMPLATE_TEXTS_HPP
#define SINEW_FORMATS_PREDICT_TEMPLATE_TEXTS_HPP

namespace sinew {

struct TemplateText {
  const char *name, *text;
};
extern const TemplateText kTemplateTexts[];  // by name; a null name ends them

}  // namespace sinew
#endif
