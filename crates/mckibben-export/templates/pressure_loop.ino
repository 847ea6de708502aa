/* A closed loop: the muscle @{name} holds a pull at a length, with a pressure sensor and a proportional valve.
 * Arduino: its folder has to be called @{id}_loop; the other files may stay in it.
 * @{facts}
 */
#include "@{id}.h"

/* Your hardware: sensor of 0 to 5 V over the range, valve by the width of pulses, potentiometer for the length. */
static const int SENSOR = A0, LENGTH = A1, VALVE = 9;
static const float RANGE_PA = 1.25f * @{supply}f, STROKE_M = 0.3f * @{length}f;
/* Pull that the muscle shall hold, and the controller: proportional and integral, 100 times a second. */
static const float WANTED_N = @{wanted}f, STEP_S = 0.01f, GAIN = 2.0f, PER_S = 8.0f;

static float integral = 0.0f;

void setup()
{
    pinMode(VALVE, OUTPUT);
}

void loop()
{
    const float pressure = RANGE_PA * (float)analogRead(SENSOR) / 1023.0f;
    const float length = (float)(@{id}.cord + @{id}.length) - STROKE_M * (float)analogRead(LENGTH) / 1023.0f;
    unsigned status;
    float wanted = (float)mckibben_pressure(&@{id}, WANTED_N, length, &status);
    if (status & MCKIBBEN_CONTRACTION_OUTSIDE) /* the potentiometer shows what the muscle cannot: vent */
        wanted = integral = 0.0f;
    const float missing = (wanted - pressure) / (float)@{id}.supply;
    float drive = wanted / RANGE_PA + GAIN * missing + integral;
    if (drive > 0.0f && drive < 1.0f) /* the integral waits while the valve is at an end */
        integral += PER_S * STEP_S * missing;
    drive = drive < 0.0f ? 0.0f : (drive > 1.0f ? 1.0f : drive);
    analogWrite(VALVE, (int)(255.0f * drive + 0.5f));
    delay(10);
}
