// Nothing of its own: the lessons share what is precompiled for this file.
