# Writes OUTPUT, a C file in which the bytes of INPUT are the array NAME.
cmake_minimum_required(VERSION 3.25)
file(READ ${INPUT} bytes HEX)
string(REPEAT ".." 64 line)
string(REGEX REPLACE "(${line})" "\\1\n" bytes "${bytes}")
string(REGEX REPLACE "([0-9a-f][0-9a-f])" "\\\\x\\1" bytes "${bytes}")
string(REGEX REPLACE "([^\n]+)" "\"\\1\"" bytes "${bytes}")
file(WRITE ${OUTPUT} "const unsigned char ${NAME}[] =\n${bytes};\n")
