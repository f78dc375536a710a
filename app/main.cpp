#include "Program.h"

int main(int argc, char** argv)
{
  return mote::app::runProgram(argc, argv);
}
