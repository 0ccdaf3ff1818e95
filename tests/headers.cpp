// Nothing of its own: the tests of a room share what is precompiled for this file.
