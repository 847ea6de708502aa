/* A closed loop: the muscle @{name} holds a pull at a length, with a pressure sensor and a proportional valve.
 * Arduino: its folder has to be called @{id}_loop; the other files may stay in it.
 * Made by mckibben @{version}.
 */
#include "@{id}.h"

/* Your hardware: sensor of 0.5 to 4.5 V over the range (at 0 or 5 V its wire is broken), valve by the width of pulses (closed it vents the muscle),
 * potentiometer for the length. */
static const int SENSOR = A0, LENGTH = A1, VALVE = 9;
static const float RANGE_PA = 1.25f * @{supply}f, STROKE_M = 0.3f * @{length}f;
/* No pressure above this one is commanded, also not by a sensor that shows too little. */
static const float ALLOWED_PA = (float)@{id}.allowed, MOST = ALLOWED_PA < RANGE_PA ? ALLOWED_PA / RANGE_PA : 1.0f;
/* So many cycles with a dead sensor vent the muscle until the board is reset. */
static const int DEAD_CYCLES = 5;
/* Pull that the muscle shall hold, and the controller: proportional and integral, 100 times a second. */
static const float WANTED_N = @{wanted}f, STEP_S = 0.01f, GAIN = 2.0f, PER_S = 8.0f;

static float integral = 0.0f;
static int dead = 0;

void setup()
{
    pinMode(VALVE, OUTPUT);
}

void loop()
{
    const int reading = analogRead(SENSOR); /* 102 to 921 of 1023 */
    const float pressure = RANGE_PA * ((float)reading - 102.3f) / 818.4f;
    const mckibben_real length = @{id}.cord + @{id}.length - STROKE_M * (float)analogRead(LENGTH) / 1023.0f;
    unsigned status;
    float wanted = (float)mckibben_pressure(&@{id}, WANTED_N, length, &status);
    wanted = wanted < ALLOWED_PA ? wanted : ALLOWED_PA;
    if (dead < DEAD_CYCLES)
        dead = reading < 51 || reading > 972 ? dead + 1 : 0;
    /* Vent: the sensor is dead, the potentiometer shows what the muscle cannot, or no pressure gives this pull. */
    const bool vents = dead >= DEAD_CYCLES || status & (MCKIBBEN_CONTRACTION_OUTSIDE | MCKIBBEN_NO_ANSWER) || pressure > 1.05f * ALLOWED_PA;
    const float missing = (wanted - pressure) / (float)@{id}.supply;
    float drive = wanted / RANGE_PA + GAIN * missing + integral;
    if (drive > 0.0f && drive < MOST) /* the integral waits while the valve is at an end */
        integral += PER_S * STEP_S * missing;
    drive = drive < 0.0f ? 0.0f : (drive > MOST ? MOST : drive);
    if (vents)
        drive = integral = 0.0f;
    analogWrite(VALVE, (int)(255.0f * drive)); /* rounded down */
    delay(10);
}
